#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/bytes.h"
#include "core/huge_pages.h"
#include "core/strand_groups.h"
#include "core/vector3.h"

namespace ringlet {

/// A number a vertex in lane order, one pack a row.
using VertexScalars = StreamedVector<Pack>;

/// A 3-vector a vertex (positions, velocities, gradients, ...) in lane order.
class VertexField {
 public:
  VertexField() = default;
  /// All zero, pads included. The groups must outlive the field.
  explicit VertexField(const StrandGroups& groups);

  const StrandGroups& groups() const { return *groups_; }
  std::span<Vector3<Pack>> rows() { return rows_; }
  std::span<const Vector3<Pack>> rows() const { return rows_; }
  std::span<Vector3<Pack>> group(int g) {
    return std::span(rows_).subspan((*groups_)[g].first_row, (*groups_)[g].vertices);
  }
  std::span<const Vector3<Pack>> group(int g) const {
    return std::span(rows_).subspan((*groups_)[g].first_row, (*groups_)[g].vertices);
  }

  Eigen::Vector3d get(int vertex) const {
    const auto [row, lane] = groups_->slot(vertex);
    const Vector3<Pack>& p = rows_[row];
    return {p.x[lane], p.y[lane], p.z[lane]};
  }
  void set(int vertex, const Eigen::Vector3d& value) {
    const auto [row, lane] = groups_->slot(vertex);
    rows_[row].x[lane] = value.x();
    rows_[row].y[lane] = value.y();
    rows_[row].z[lane] = value.z();
  }
  void add(int vertex, const Eigen::Vector3d& value) { set(vertex, get(vertex) + value); }
  void set_zero();

  std::size_t bytes() const { return bytes_of(rows_); }
  /// 3 x V, column i = vertex i.
  Eigen::Matrix3Xd matrix() const;
  void set_matrix(const Eigen::Matrix3Xd& values);

 private:
  const StrandGroups* groups_ = nullptr;
  StreamedVector<Vector3<Pack>> rows_;
};

/// The i-th vertex of the benign helix that pads stand on, m.
Vector3<double> pad_position(int i);
/// Positions of all vertices, with the helix on the pads.
VertexField positions_with_pads(const StrandGroups& groups,
                                std::span<const Eigen::Vector3d> positions);

/// Sum over all vertices; summed a group at a time in fixed order, so independent of the threads.
double dot(const VertexField& a, const VertexField& b);
/// y += alpha x.
void add_scaled(VertexField& y, double alpha, const VertexField& x);

}  // namespace ringlet
