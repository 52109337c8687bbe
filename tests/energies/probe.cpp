#include "tests/energies/probe.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "energies/modules.h"

namespace ringlet::test {

namespace {

template <class Interface>
std::unique_ptr<Interface> make(const Json& json) {
  Registry registry;
  register_energies(registry);
  std::vector<Problem> problems;
  ParseContext context{registry, ".", {}, problems};
  Choice<Interface> choice;
  Codec<Choice<Interface>>::read(json, "", {}, context, choice);
  if (!problems.empty()) throw InvalidScene(problems);
  return choice.make();
}

}  // namespace

std::unique_ptr<Energy> make_energy(const Json& json) { return make<Energy>(json); }
std::unique_ptr<Force> make_force(const Json& json) { return make<Force>(json); }

Material plain_material() {
  return {.youngs_modulus = 1e6, .shear_modulus = 4e5, .density = 1000, .radius = 3e-2};
}

Bound::Bound(std::unique_ptr<Energy> energy, const std::vector<int>& vertex_counts,
             const Points& rest, const Material& material)
    : strands_(vertex_counts, columns(rest), material),
      groups_(strands_),
      energy_(std::move(energy)) {
  energy_->bind(strands_, groups_);
}

Probe Bound::at(const Points& x) const { return probe(*energy_, groups_, x); }

double Bound::value(const Points& x) const {
  const VertexField field = positions_with_pads(groups_, columns(x));
  double value = 0;
  for (int g = 0; g < groups_.count(); ++g) value += energy_->add(g, field.group(g), {});
  return value;
}

template <class Term>
Probe probe(const Term& term, const StrandGroups& groups, const Points& x) {
  const VertexField field = positions_with_pads(groups, columns(x));
  VertexField gradient(groups);
  StrandBands bands(groups);
  Probe result{0, {}, Eigen::MatrixXd::Zero(x.size(), x.size())};
  for (int g = 0; g < groups.count(); ++g) {
    result.value += term.add(g, field.group(g), {gradient.group(g), bands.group(g)});
  }
  result.gradient = gradient.matrix().reshaped();
  for (int v = 0; v < groups.vertex_count(); ++v) {
    const auto [row, lane] = groups.slot(v);
    for (int k = 0; k < band_blocks && k <= v; ++k) {
      if (groups.slot(v - k).lane != lane || groups.slot(v - k).row != row - k) break;
      for (int m = 0; m < 9; ++m) {
        const double entry = bands.block(row, k).m[m][lane];
        result.hessian(3 * v + m / 3, 3 * (v - k) + m % 3) = entry;
        result.hessian(3 * (v - k) + m % 3, 3 * v + m / 3) = entry;
      }
    }
  }
  return result;
}
template Probe probe(const Energy&, const StrandGroups&, const Points&);
template Probe probe(const Force&, const StrandGroups&, const Points&);

std::vector<Eigen::Vector3d> columns(const Points& x) {
  return {x.colwise().begin(), x.colwise().end()};
}

Points random_points(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Points points(3, count);
  for (double& value : points.reshaped()) value = coordinate(random);
  return points;
}

Eigen::Matrix3d random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

double smallest_eigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues()(0);
}

Points random_stencil(std::mt19937& random, int vertices, Shape shape, double nearly) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double pi = std::numbers::pi;
  const double small = nearly * between(0.5, 1);
  double bend = between(0.3, 2.8), torsion = between(-3, 3), last_bend = between(0.3, 2.8);
  if (shape == Shape::nearly_straight || shape == Shape::straight_end) bend = small;
  if (shape == Shape::nearly_folded) bend = pi - small;
  if (shape == Shape::nearly_cis) torsion = small;
  if (shape == Shape::nearly_trans) torsion = pi - small;

  // The middle edge lies along x; bend is the angle by which the strand turns at its ends.
  Points points = Points::Zero(3, 4);
  points.col(0) = between(0.5, 2) * Eigen::Vector3d(-std::cos(bend), std::sin(bend), 0);
  points.col(2) = Eigen::Vector3d(between(0.5, 2), 0, 0);
  points.col(3) =
      points.col(2) + between(0.5, 2) * Eigen::Vector3d(std::cos(last_bend),
                                                        std::sin(last_bend) * std::cos(torsion),
                                                        std::sin(last_bend) * std::sin(torsion));
  const Eigen::Vector3d origin(between(-1, 1), between(-1, 1), between(-1, 1));
  const Points moved = (random_rotation(random) * points).colwise() + origin;
  return moved.leftCols(vertices);
}

}  // namespace ringlet::test
