#pragma once

#include <memory>
#include <random>
#include <string>

#include "core/energy.h"
#include "core/force.h"
#include "core/registry.h"

namespace ringlet::test {

/// 3 x V, a column a vertex.
using Points = Eigen::Matrix3Xd;

/// Everything an energy or a force says about a set of strands, dense.
struct Probe {
  double value;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};

/// Plugins of the registry with the given JSON, {"type": NAME, ...}.
std::unique_ptr<Energy> make_energy(const Json& json);
std::unique_ptr<Force> make_force(const Json& json);

/// A material of plain numbers: about 1 N of bending a metre, thick and soft.
Material plain_material();

/// Strands with an energy bound to their rest shape.
class Bound {
 public:
  Bound(std::unique_ptr<Energy> energy, const std::vector<int>& vertex_counts, const Points& rest,
        const Material& material = plain_material());
  /// One strand.
  Bound(const std::string& type, const Points& rest, const std::string& filter = "exact")
      : Bound(make_energy({{"type", type}, {"filter", filter}}), {int(rest.cols())}, rest) {}

  Probe at(const Points& x) const;
  double value(const Points& x) const;
  const Strands& strands() const { return strands_; }
  const StrandGroups& groups() const { return groups_; }

 private:
  Strands strands_;
  StrandGroups groups_;
  std::unique_ptr<Energy> energy_;
};

/// The same for anything with Energy's add().
template <class Term>
Probe probe(const Term& term, const StrandGroups& groups, const Points& x);

std::vector<Eigen::Vector3d> columns(const Points& x);
/// Coordinates in [-1, 1].
Points random_points(std::mt19937& random, int count);
Eigen::Matrix3d random_rotation(std::mt19937& random);

double smallest_eigenvalue(const Eigen::MatrixXd& matrix);

/// Kinds of stencils that random points alone would never show.
enum class Shape {
  generic,
  nearly_straight,
  nearly_folded,
  nearly_cis,
  nearly_trans,
  straight_end
};
inline constexpr Shape all_shapes[] = {Shape::generic,       Shape::nearly_straight,
                                       Shape::nearly_folded, Shape::nearly_cis,
                                       Shape::nearly_trans,  Shape::straight_end};
/// Two, three or four vertices with edges of about 1 m; `nearly` is the angle off the special
/// shape.
Points random_stencil(std::mt19937& random, int vertices, Shape shape, double nearly = 1e-3);

}  // namespace ringlet::test
