#include "core/vertex_field.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace ringlet {

VertexField::VertexField(const StrandGroups& groups) : groups_(&groups), rows_(groups.rows()) {
  set_zero();
}

void VertexField::set_zero() { std::fill(rows_.begin(), rows_.end(), Vector3<Pack>{0, 0, 0}); }

Eigen::Matrix3Xd VertexField::matrix() const {
  Eigen::Matrix3Xd values(3, groups_->vertex_count());
  for (int v = 0; v < groups_->vertex_count(); ++v) values.col(v) = get(v);
  return values;
}

void VertexField::set_matrix(const Eigen::Matrix3Xd& values) {
  for (int v = 0; v < groups_->vertex_count(); ++v) set(v, values.col(v));
}

Vector3<double> pad_position(int i) { return {std::cos(1.2 * i), std::sin(1.2 * i), 0.3 * i}; }

VertexField positions_with_pads(const StrandGroups& groups,
                                std::span<const Eigen::Vector3d> positions) {
  VertexField field(groups);
  for (int g = 0; g < groups.count(); ++g) {
    std::span<Vector3<Pack>> rows = field.group(g);
    for (int i = 0; i < groups[g].vertices; ++i) {
      const Vector3<double> pad = pad_position(i);
      rows[i] = {Pack(pad.x), Pack(pad.y), Pack(pad.z)};
    }
  }
  for (int v = 0; v < groups.vertex_count(); ++v) field.set(v, positions[v]);
  return field;
}

double dot(const VertexField& a, const VertexField& b) {
  return parallel_sum(a.groups().count(), [&](int g) {
    Pack sum = 0;
    const auto rows_a = a.group(g), rows_b = b.group(g);
    for (std::size_t i = 0; i < rows_a.size(); ++i) sum += dot(rows_a[i], rows_b[i]);
    return sum_lanes(sum);
  });
}

void add_scaled(VertexField& y, double alpha, const VertexField& x) {
  parallel_for_each(y.groups().count(), [&](int g) {
    const auto rows_y = y.group(g);
    const auto rows_x = x.group(g);
    for (std::size_t i = 0; i < rows_y.size(); ++i) rows_y[i] += Pack(alpha) * rows_x[i];
  });
}

}  // namespace ringlet
