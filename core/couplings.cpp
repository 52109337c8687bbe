#include "core/couplings.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/parallel.h"

namespace ringlet {
namespace {

constexpr int not_coupled = -1;
/// For a group.
constexpr int none = -1;
/// The other edges that an edge feels lie anywhere in memory: they are fetched so many terms ahead.
constexpr std::size_t prefetched = 8;
/// Terms that a thread sorts in one go.
constexpr int terms_a_block = 4096;

void prefetch(const CouplingTerm& term) {
  constexpr std::size_t cache_line = 64;
  const char* bytes = reinterpret_cast<const char*>(&term);
  for (std::size_t n = 0; n < sizeof(term); n += cache_line) __builtin_prefetch(bytes + n);
}

}  // namespace

void Couplings::clear() {
  terms_.clear();
  tuples_.clear();
  parallel_for_each(static_cast<int>(of_group_.size()), [&](int g) {
    for (const int vertex : coupled(g)) place_[vertex] = not_coupled;
    OfGroup& group = of_group_[g];
    group.part_count = group.felt_count = 0;
    group.tuple_parts.clear();
    group.blocks.clear();
    group.first_coupled = group.coupled_count = 0;
  });
  coupled_.clear();
}

/// The term of a part. Fetches that of a later one: they lie anywhere in memory.
inline const CouplingTerm& Couplings::term_of(std::span<const Part> parts, std::size_t n) const {
  if (n + prefetched < parts.size()) prefetch(terms_[parts[n + prefetched].term]);
  return terms_[parts[n].term];
}

std::span<CouplingTerm> Couplings::append(int count) {
  terms_.resize(terms_.size() + count);
  return std::span(terms_).last(count);
}

bool Couplings::is_one_part(const CouplingTerm& term) const {
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < a; ++b) {
      const bool both = term.weights[a] != 0 && term.weights[b] != 0;
      if (both && !fit_into_band(term.vertices[a], term.vertices[b])) return false;
    }
  }
  return true;
}

bool Couplings::fit_into_band(int i, int j) const {
  const LaneSlot a = groups_->slot(i), b = groups_->slot(j);
  return a.lane == b.lane && std::abs(a.row - b.row) < band_blocks &&
         groups_->group_of(i) == groups_->group_of(j);
}

void Couplings::finish(const VertexScalars& free) {
  if (empty()) return;
  distribute();
  for (int t = 0; t < static_cast<int>(tuples_.size()); ++t) distribute(t);
  parallel_for_each(groups_->count(), [&](int g) {
    find_felt(g, free);
    find_blocks(g, free);
  });
  int count = 0;
  for (OfGroup& group : of_group_) {
    group.first_coupled = count;
    count += group.coupled_count;
  }
  coupled_.resize(count);
  parallel_for_each(groups_->count(), [&](int g) { number_coupled(g); });
  parallel_for_each(groups_->count(), [&](int g) {
    const OfGroup& group = of_group_[g];
    for (Felt& felt : std::span(felt_).subspan(group.first_part, group.felt_count)) {
      for (int& vertex : felt.rows) vertex = place_[vertex];
      for (int& vertex : felt.columns) vertex = place_[vertex];
    }
    for (Block& block : of_group_[g].blocks) {
      block.row = place_[block.row];
      block.column = place_[block.column];
    }
  });
}

/// A counting sort.
void Couplings::distribute() {
  const int count = static_cast<int>(terms_.size()), groups = groups_->count();
  const int blocks = (count + terms_a_block - 1) / terms_a_block;
  split_.resize(count);
  begins_.assign(blocks * groups, 0);
  parallel_for_each(blocks, [&](int block) {
    const int end = std::min(count, (block + 1) * terms_a_block);
    for (int t = block * terms_a_block; t < end; ++t) split_[t] = split(terms_[t]);
    for_each_part(block, [&](int g, const Part&) { ++begins_[block * groups + g]; });
  });
  parallel_for_each(groups, [&](int g) {
    int parts = 0;
    for (int block = 0; block < blocks; ++block) {
      parts += std::exchange(begins_[block * groups + g], parts);
    }
    of_group_[g].part_count = parts;
  });
  int parts = 0;
  for (OfGroup& group : of_group_) {
    group.first_part = parts;
    parts += group.part_count;
  }
  parts_.resize(parts);
  felt_.resize(parts);
  parallel_for_each(blocks, [&](int block) {
    for_each_part(block, [&](int g, const Part& part) {
      parts_[of_group_[g].first_part + begins_[block * groups + g]++] = part;
    });
  });
}

/// visit(group, part) for those of the terms of a block, in their order.
template <class Visit>
void Couplings::for_each_part(int block, const Visit& visit) const {
  const int end = std::min(static_cast<int>(terms_.size()), (block + 1) * terms_a_block);
  for (int t = block * terms_a_block; t < end; ++t) {
    const auto [whole, first, second] = split_[t];
    if (first != none) visit(first, Part{t, 0, whole ? 4 : 2});
    if (second != none) visit(second, Part{t, 2, 4});
  }
}

Couplings::Split Couplings::split(const CouplingTerm& term) const {
  const auto group_of = [&](int first, int end) {
    for (int i = first; i < end; ++i) {
      if (term.weights[i] != 0) return groups_->group_of(term.vertices[i]);
    }
    return none;
  };
  if (is_one_part(term)) return {true, group_of(0, 4), none};
  return {false, group_of(0, 2), group_of(2, 4)};
}

/// Each vertex joins the first part with all of whose vertices it fits into the bands.
void Couplings::distribute(int tuple) {
  const TupleTerm& term = tuples_[tuple];
  std::array<TuplePart, 4> parts;
  int count = 0;
  for (int i = 0; i < term.count; ++i) {
    int p = 0;
    while (p < count && !fits(term, parts[p], i)) ++p;
    if (p == count) parts[count++] = {tuple, {}};
    parts[p].has[i] = true;
  }
  for (int p = 0; p < count; ++p) {
    const auto first = std::find(parts[p].has.begin(), parts[p].has.end(), true);
    const int group = groups_->group_of(term.vertices[first - parts[p].has.begin()]);
    of_group_[group].tuple_parts.push_back(parts[p]);
  }
}

bool Couplings::fits(const TupleTerm& term, const TuplePart& part, int member) const {
  for (int i = 0; i < term.count; ++i) {
    if (part.has[i] && !fit_into_band(term.vertices[i], term.vertices[member])) return false;
  }
  return true;
}

/// As find_felt().
void Couplings::find_blocks(int g, const VertexScalars& free) {
  for (const TuplePart& part : of_group_[g].tuple_parts) {
    const TupleTerm& term = tuples_[part.tuple];
    for (int i = 0; i < term.count; ++i) {
      if (!part.has[i] || !is_free(term.vertices[i], free)) continue;
      for (int j = 0; j < term.count; ++j) {
        if (part.has[j] || !is_free(term.vertices[j], free)) continue;
        const Eigen::Matrix3d& h = term.hessian[i][j];
        of_group_[g].blocks.push_back(
            {term.vertices[i],
             term.vertices[j],
             {h(0, 0), h(0, 1), h(0, 2), h(1, 0), h(1, 1), h(1, 2), h(2, 0), h(2, 1), h(2, 2)}});
        mark(g, term.vertices[i]);
      }
    }
  }
}

/// Leaves the numbers of vertices in rows and columns, and marks the places of the rows.
void Couplings::find_felt(int g, const VertexScalars& free) {
  OfGroup& group = of_group_[g];
  const std::span<const Part> parts = parts_of(group);
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const CouplingTerm& term = term_of(parts, n);
    const int first = parts[n].first;
    if (parts[n].end - first == 4) continue;
    const FreeEnd row = free_end(term, first, free), column = free_end(term, 2 - first, free);
    if (!row.has_weight() || !column.has_weight()) continue;
    const Eigen::Matrix3d& c = term.curvature;
    felt_[group.first_part + group.felt_count++] = {
        row.vertices,
        column.vertices,
        row.weights,
        column.weights,
        {c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)}};
    for (const int vertex : row.vertices) mark(g, vertex);
  }
}

void Couplings::mark(int group, int vertex) {
  of_group_[group].coupled_count += place_[vertex] == not_coupled ? 1 : 0;
  place_[vertex] = 0;
}

bool Couplings::is_free(int vertex, const VertexScalars& free) const {
  const auto [row, lane] = groups_->slot(vertex);
  return free[row][lane] != 0;
}

/// An edge of a term without what is pinned. A vertex without weight is replaced by the other one.
Couplings::FreeEnd Couplings::free_end(const CouplingTerm& term, int first,
                                       const VertexScalars& free) const {
  FreeEnd end{{term.vertices[first], term.vertices[first + 1]}, {0, 0}};
  for (int i = 0; i < 2; ++i) {
    if (is_free(end.vertices[i], free)) end.weights[i] = term.weights[first + i];
  }
  if (end.weights[0] == 0) end.vertices[0] = end.vertices[1];
  if (end.weights[1] == 0) end.vertices[1] = end.vertices[0];
  return end;
}

void Couplings::number_coupled(int g) {
  const StrandGroup& strands = (*groups_)[g];
  OfGroup& group = of_group_[g];
  int place = group.first_coupled;
  if (group.coupled_count == 0) return;
  group.first_coupled_row = strands.vertices;
  for (int lane = 0; lane < lane_count; ++lane) {
    for (int row = 0; row < strands.vertices; ++row) {
      const int vertex = groups_->vertex_at(strands.first_row + row, lane);
      if (vertex < 0 || place_[vertex] == not_coupled) continue;
      coupled_[place] = vertex;
      place_[vertex] = place++;
      group.first_coupled_row = std::min(group.first_coupled_row, row);
    }
  }
}

void Couplings::add_gradient(int group, std::span<Vector3<Pack>> rows) const {
  const int first_row = (*groups_)[group].first_row;
  const auto add_force = [&](int vertex, const Eigen::Vector3d& gradient) {
    const auto [row, lane] = groups_->slot(vertex);
    Vector3<Pack>& target = rows[row - first_row];
    target.x[lane] = target.x[lane] + gradient.x();
    target.y[lane] = target.y[lane] + gradient.y();
    target.z[lane] = target.z[lane] + gradient.z();
  };
  const std::span<const Part> parts = parts_of(of_group_[group]);
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const CouplingTerm& term = term_of(parts, n);
    for (int i = parts[n].first; i < parts[n].end; ++i) {
      if (term.weights[i] == 0) continue;
      add_force(term.vertices[i], term.weights[i] * term.gradient);
    }
  }
  for (const TuplePart& part : of_group_[group].tuple_parts) {
    const TupleTerm& term = tuples_[part.tuple];
    for (int i = 0; i < term.count; ++i) {
      if (part.has[i]) add_force(term.vertices[i], term.gradient[i]);
    }
  }
}

void Couplings::add_to_bands(int group, GroupBands bands) const {
  const int first_row = (*groups_)[group].first_row;
  const std::span<const Part> parts = parts_of(of_group_[group]);
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const CouplingTerm& term = term_of(parts, n);
    for (int i = parts[n].first; i < parts[n].end; ++i) {
      for (int j = parts[n].first; j <= i; ++j) {
        const double weight = term.weights[i] * term.weights[j];
        if (weight == 0) continue;
        const LaneSlot a = groups_->slot(term.vertices[i]), b = groups_->slot(term.vertices[j]);
        Matrix3<Pack>& block =
            bands.block(std::max(a.row, b.row) - first_row, std::abs(a.row - b.row));
        for (int m = 0; m < 9; ++m) {
          block.m[m][a.lane] = block.m[m][a.lane] + weight * term.curvature(m / 3, m % 3);
        }
      }
    }
  }
  for (const TuplePart& part : of_group_[group].tuple_parts) {
    add_to_bands(part, first_row, bands);
  }
}

void Couplings::add_to_bands(const TuplePart& part, int first_row, GroupBands bands) const {
  const TupleTerm& term = tuples_[part.tuple];
  for (int i = 0; i < term.count; ++i) {
    for (int j = 0; j < term.count; ++j) {
      const LaneSlot a = groups_->slot(term.vertices[i]), b = groups_->slot(term.vertices[j]);
      if (!part.has[i] || !part.has[j] || b.row > a.row) continue;
      Matrix3<Pack>& block = bands.block(a.row - first_row, a.row - b.row);
      for (int m = 0; m < 9; ++m) {
        block.m[m][a.lane] = block.m[m][a.lane] + term.hessian[i][j](m / 3, m % 3);
      }
    }
  }
}

Eigen::Matrix3d Couplings::Felt::full() const {
  const auto& [xx, xy, xz, yy, yz, zz] = curvature;
  return Eigen::Matrix3d{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
}

inline Vector3<double> Couplings::Felt::force(const Vector3<double>& u) const {
  const auto& [xx, xy, xz, yy, yz, zz] = curvature;
  return {xx * u.x + xy * u.y + xz * u.z, xy * u.x + yy * u.y + yz * u.z,
          xz * u.x + yz * u.y + zz * u.z};
}

void Couplings::multiply(int group, std::span<const Vector3<double>> x,
                         std::span<Vector3<double>> y) const {
  std::fill(y.begin(), y.end(), Vector3<double>{0, 0, 0});
  const int first = of_group_[group].first_coupled;
  const std::span<const Felt> all = felt_of(of_group_[group]);
  for (std::size_t n = 0; n < all.size(); ++n) {
    const Felt& felt = all[n];
    if (n + prefetched < all.size()) __builtin_prefetch(&x[all[n + prefetched].columns[0]]);
    const Vector3<double> force = felt.force(felt.column_weights[0] * x[felt.columns[0]] +
                                             felt.column_weights[1] * x[felt.columns[1]]);
    for (int i = 0; i < 2; ++i) y[felt.rows[i] - first] += felt.row_weights[i] * force;
  }
  for (const Block& block : of_group_[group].blocks)
    y[block.row - first] += block * x[block.column];
}

void Couplings::add_product(int group, const VertexField& x, VertexField& y) const {
  const auto at = [&](int place) { return from_eigen(x.get(coupled_[place])); };
  for (const Felt& felt : felt_of(of_group_[group])) {
    const Vector3<double> force = felt.force(felt.column_weights[0] * at(felt.columns[0]) +
                                             felt.column_weights[1] * at(felt.columns[1]));
    for (int i = 0; i < 2; ++i) {
      y.add(coupled_[felt.rows[i]], to_eigen(felt.row_weights[i] * force));
    }
  }
  for (const Block& block : of_group_[group].blocks) {
    y.add(coupled_[block.row], to_eigen(block * at(block.column)));
  }
}

std::size_t Couplings::bytes() const {
  std::size_t sum = bytes_of(terms_) + bytes_of(tuples_) + bytes_of(split_) + bytes_of(begins_) +
                    bytes_of(parts_) + bytes_of(felt_) + bytes_of(of_group_) + bytes_of(coupled_) +
                    bytes_of(place_);
  for (const OfGroup& group : of_group_) {
    sum += bytes_of(group.tuple_parts) + bytes_of(group.blocks);
  }
  return sum;
}

}  // namespace ringlet
