#pragma once

#include <memory>
#include <vector>

#include "core/energy.h"
#include "core/force.h"

namespace ringlet {

/// 3 x V, m: a column a vertex.
using Points = Eigen::Matrix3Xd;

/// Everything an energy or a force says about a set of strands, dense.
struct Probe {
  double value;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
  double asymmetry;  ///< largest difference between an entry of a diagonal block and its mirror

  bool is_finite() const;
};

/// Everything at positions x, of an Energy or a Force that is bound to the groups.
template <class Term>
Probe probe(const Term& term, const StrandGroups& groups, const Points& x);

/// A material of plain numbers, for strands with edges of about 1 m.
Material plain_material();

/// An energy bound to strands of its own.
class BoundEnergy {
 public:
  /// Strands of the given numbers of vertices, one after the other in the rest shape.
  BoundEnergy(std::unique_ptr<Energy> energy, const std::vector<int>& vertex_counts,
              const Points& rest, const Material& material = plain_material());
  /// One strand.
  BoundEnergy(std::unique_ptr<Energy> energy, const Points& rest)
      : BoundEnergy(std::move(energy), {static_cast<int>(rest.cols())}, rest) {}

  Probe at(const Points& x) const;
  /// Asked for no derivatives.
  double value(const Points& x) const;
  const Energy& energy() const { return *energy_; }
  const Strands& strands() const { return strands_; }
  const StrandGroups& groups() const { return groups_; }

 private:
  Strands strands_;
  StrandGroups groups_;
  std::unique_ptr<Energy> energy_;
};

std::vector<Eigen::Vector3d> columns(const Points& x);

/// A symmetric matrix that is not finite has the smallest eigenvalue -infinity.
double smallest_eigenvalue(const Eigen::MatrixXd& matrix);

}  // namespace ringlet
