#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/edge_derivatives.h"
#include "core/element.h"
#include "core/named.h"
#include "core/step_start.h"
#include "core/strands.h"
#include "core/vertex_field.h"

namespace ringlet {

/// Everything about one element, dense.
struct ElementDerivatives {
  double value;              ///< J
  Eigen::VectorXd gradient;  ///< with respect to the stacked positions, N
  Eigen::MatrixXd hessian;   ///< N/m
};

/// What an element costs where its gradient and filtered Hessian are added in lanes.
struct ElementCost {
  std::int64_t operations;  ///< as core/counted.h counts them, without those of a numeric filter
  int rest_bytes;           ///< of its rest data
};

/// One element of an energy by itself, for tools and tests.
class ElementFunction {
 public:
  virtual ~ElementFunction() = default;
  virtual int vertices() const = 0;
  /// Value, gradient and filtered Hessian at positions (3 x vertices, m), of an element with the
  /// given stiffness k, J, and its measure (length, angle) at rest.
  virtual ElementDerivatives evaluate(const Eigen::Matrix3Xd& positions, double stiffness,
                                      double rest) const = 0;
  /// The same element's cost, a lane.
  virtual ElementCost cost(const Eigen::Matrix3Xd& positions, double stiffness,
                           double rest) const = 0;
};

/// The elements of an energy that can choose their rest state, each named by its first vertex.
class HoldingElements {
 public:
  virtual ~HoldingElements() = default;
  virtual int vertices() const = 0;
  /// As HoldingKernel's hold, at positions (3 x vertices, m).
  virtual Hold hold(int first_vertex, const Eigen::Matrix3Xd& x, double slope) = 0;
  /// With the exact Hessian.
  virtual ElementDerivatives derivatives(int first_vertex, const Eigen::Matrix3Xd& x) const = 0;
};

/// One term of the elastic potential of the strands: a function of their edges alone. (What depends
/// on where a strand is in space is a Force.)
class Energy : public Named {
 public:
  virtual ~Energy() = default;

  /// Computes rest data from the strands' rest shape. Called once, before add().
  virtual void bind(const Strands& strands, const StrandGroups& groups) = 0;

  /// Whether it is zero wherever the strands are, now and later, as without stiffness. It is then
  /// left out.
  virtual bool vanishes() const { return false; }

  /// A step begins. An energy whose rest shape flows, or that is driven, changes its rest data here
  /// and nowhere else; called once a step, before begin_step() of the forces.
  virtual void begin_step(const StepStart& start) { (void)start; }
  /// What begin_step() changes; empty if it changes nothing. A step that is tried again begins with
  /// a copy of it.
  virtual std::span<std::byte> changing_data() { return {}; }

  /// Returns the energy of a group of strands at positions x, J. Adds its gradient with respect to
  /// the edges e_i = x_{i+1} - x_i, and its Hessian, made positive semi-definite by the energy's
  /// filter, where they are wanted. Called from several threads at once, for different groups.
  virtual double add(int group, std::span<const Vector3<Pack>> x, EdgeOutputs outputs) const = 0;

  /// Its elements one by one; null where they do not follow from a stiffness and one rest value.
  virtual const ElementFunction* element_function() const { return nullptr; }
  /// Its elements where they can choose their rest state, else null.
  virtual HoldingElements* holding_elements() { return nullptr; }
};

/// The same with derivatives with respect to the vertices, for where time does not matter.
double add_at_vertices(const Energy& energy, int group, std::span<const Vector3<Pack>> x,
                       const GroupOutputs& outputs);

}  // namespace ringlet
