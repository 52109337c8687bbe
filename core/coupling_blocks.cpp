#include "core/coupling_blocks.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "core/parallel.h"

namespace ringlet {

void CouplingBlocks::clear() {
  entries_.clear();
  for (GroupBlocks& group : group_blocks_) {
    group.in_band.clear();
    group.references.clear();
    group.off_band.clear();
    group.coupled.clear();
  }
  off_band_count_ = coupled_count_ = 0;
}

void CouplingBlocks::add(const std::array<int, 4>& vertices, const std::array<double, 4>& weights,
                         const Eigen::Matrix3d& curvature) {
  bool fits = true;
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < a; ++b) {
      const bool both = weights[a] != 0 && weights[b] != 0;
      const int i = vertices[a], j = vertices[b];
      if (both && on_one_strand(i, j) && !fit_into_band(i, j)) fits = false;
    }
  }
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b <= a; ++b) {
      const double weight = weights[a] * weights[b];
      if (weight == 0) continue;
      const bool same_edge = a / 2 == b / 2;
      const bool in_band = (fits || same_edge) && fit_into_band(vertices[a], vertices[b]);
      entries_.push_back({vertices[a], vertices[b], in_band, weight * curvature});
    }
  }
}

bool CouplingBlocks::on_one_strand(int i, int j) const {
  return groups_->slot(i).lane == groups_->slot(j).lane &&
         groups_->group_of(i) == groups_->group_of(j);
}

bool CouplingBlocks::fit_into_band(int i, int j) const {
  return on_one_strand(i, j) && std::abs(groups_->slot(i).row - groups_->slot(j).row) < band_blocks;
}

void CouplingBlocks::refer(int row, int column, int entry, bool transposed) {
  const auto place = [&](int vertex) {
    const auto [slot_row, lane] = groups_->slot(vertex);
    return std::int64_t{slot_row} * lane_count + lane;
  };
  const std::int64_t places = std::int64_t{groups_->rows()} * lane_count;
  group_blocks_[groups_->group_of(row)].references.push_back(
      {place(row) * places + place(column), entry, transposed});
}

void CouplingBlocks::finish(const VertexScalars& free) {
  const auto is_free = [&](int vertex) {
    const auto [row, lane] = groups_->slot(vertex);
    return free[row][lane] != 0;
  };
  for (int e = 0; e < static_cast<int>(entries_.size()); ++e) {
    const Entry& entry = entries_[e];
    if (entry.in_band) {
      group_blocks_[groups_->group_of(entry.i)].in_band.push_back(e);
    } else if (is_free(entry.i) && is_free(entry.j)) {
      refer(entry.i, entry.j, e, false);
      refer(entry.j, entry.i, e, true);
    }
  }
  parallel_for_each(groups_->count(), [&](int g) { sum_off_band(group_blocks_[g]); });
  for (GroupBlocks& group : group_blocks_) {
    off_band_count_ += static_cast<int>(group.off_band.size());
    group.first_coupled = coupled_count_;
    for (const int vertex : group.coupled) place_[vertex] = coupled_count_++;
  }
}

void CouplingBlocks::sum_off_band(GroupBlocks& group) const {
  std::sort(group.references.begin(), group.references.end());
  std::int64_t last_key = -1;
  for (const Reference& reference : group.references) {
    const Entry& entry = entries_[reference.entry];
    Eigen::Matrix3d values = entry.block;
    if (reference.transposed) values.transposeInPlace();
    if (reference.key == last_key) {
      group.off_band.back().values += values;
    } else if (reference.transposed) {
      group.off_band.push_back({entry.j, entry.i, values});
    } else {
      group.off_band.push_back({entry.i, entry.j, values});
    }
    last_key = reference.key;
  }
  for (const Block& block : group.off_band) {
    if (group.coupled.empty() || group.coupled.back() != block.row) {
      group.coupled.push_back(block.row);
    }
  }
}

void CouplingBlocks::add_to_bands(int group, GroupBands bands) const {
  const int first_row = (*groups_)[group].first_row;
  for (const int e : group_blocks_[group].in_band) {
    const Entry& entry = entries_[e];
    const LaneSlot a = groups_->slot(entry.i), b = groups_->slot(entry.j);
    const bool lower = a.row >= b.row;
    Matrix3<Pack>& block = bands.block(std::max(a.row, b.row) - first_row, std::abs(a.row - b.row));
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        const double value = lower ? entry.block(r, c) : entry.block(c, r);
        Pack& target = block(r, c);
        target[a.lane] = target[a.lane] + value;
      }
    }
  }
}

void CouplingBlocks::add_product(int group, const VertexField& x, VertexField& y) const {
  const std::vector<Block>& blocks = group_blocks_[group].off_band;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    sum += blocks[k].values * x.get(blocks[k].column);
    if (k + 1 == blocks.size() || blocks[k + 1].row != blocks[k].row) {
      y.add(blocks[k].row, sum);
      sum.setZero();
    }
  }
}

void CouplingBlocks::multiply(int group, std::span<const Vector3<double>> x,
                              std::span<Vector3<double>> y) const {
  const GroupBlocks& rows = group_blocks_[group];
  auto block = rows.off_band.begin();
  for (std::size_t i = 0; i < rows.coupled.size(); ++i) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (; block != rows.off_band.end() && block->row == rows.coupled[i]; ++block) {
      sum += block->values * to_eigen(x[place_[block->column]]);
    }
    y[i] = from_eigen(sum);
  }
}

}  // namespace ringlet
