#include "core/verify/probe.h"

#include <Eigen/Eigenvalues>

namespace ringlet {

namespace {

using Block = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

/// Copies the lane of a strand from the bands into rows and columns of its vertices.
void copy_bands(const StrandBands& bands, const StrandGroups& groups, int vertex, Probe& result) {
  const auto [row, lane] = groups.slot(vertex);
  for (int k = 0; k < band_blocks && k <= vertex; ++k) {
    const auto [other_row, other_lane] = groups.slot(vertex - k);
    if (other_lane != lane || other_row != row - k) break;
    double entries[9];
    for (int m = 0; m < 9; ++m) entries[m] = bands.block(row, k).m[m][lane];
    const Block block(entries);
    if (k == 0) {
      const double asymmetry = (block - block.transpose()).cwiseAbs().maxCoeff();
      result.asymmetry = std::max(result.asymmetry, asymmetry);
    }
    result.hessian.block<3, 3>(3 * (vertex - k), 3 * vertex) = block.transpose();
    result.hessian.block<3, 3>(3 * vertex, 3 * (vertex - k)) = block;
  }
}

double add(const Energy& energy, int group, std::span<const Vector3<Pack>> x,
           const GroupOutputs& outputs) {
  return add_at_vertices(energy, group, x, outputs);
}
double add(const Force& force, int group, std::span<const Vector3<Pack>> x,
           const GroupOutputs& outputs) {
  return force.add(group, x, outputs);
}

}  // namespace

bool Probe::is_finite() const {
  return std::isfinite(value) && gradient.allFinite() && hessian.allFinite();
}

template <class Term>
Probe probe(const Term& term, const StrandGroups& groups, const Points& x) {
  const VertexField field = positions_with_pads(groups, columns(x));
  VertexField gradient(groups);
  StrandBands bands(groups);
  Probe result{0, {}, Eigen::MatrixXd::Zero(x.size(), x.size()), 0};
  for (int g = 0; g < groups.count(); ++g) {
    result.value += add(term, g, field.group(g), {gradient.group(g), bands.group(g)});
  }
  result.gradient = gradient.matrix().reshaped();
  for (int v = 0; v < groups.vertex_count(); ++v) copy_bands(bands, groups, v, result);
  return result;
}
template Probe probe(const Energy&, const StrandGroups&, const Points&);
template Probe probe(const Force&, const StrandGroups&, const Points&);

Material plain_material() {
  return {.youngs_modulus = 1e6, .shear_modulus = 4e5, .density = 1000, .radius = 3e-2};
}

BoundEnergy::BoundEnergy(std::unique_ptr<Energy> energy, const std::vector<int>& vertex_counts,
                         const Points& rest, const Material& material)
    : strands_(vertex_counts, columns(rest), material),
      groups_(strands_),
      energy_(std::move(energy)) {
  energy_->bind(strands_, groups_);
}

Probe BoundEnergy::at(const Points& x) const { return probe(*energy_, groups_, x); }

double BoundEnergy::value(const Points& x) const {
  const VertexField field = positions_with_pads(groups_, columns(x));
  double value = 0;
  for (int g = 0; g < groups_.count(); ++g) value += energy_->add(g, field.group(g), {});
  return value;
}

std::vector<Eigen::Vector3d> columns(const Points& x) {
  return {x.colwise().begin(), x.colwise().end()};
}

double smallest_eigenvalue(const Eigen::MatrixXd& matrix) {
  if (!matrix.allFinite()) return -std::numeric_limits<double>::infinity();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues()(0);
}

}  // namespace ringlet
