// Near pairs of edges by sorted cells. Every edge stands, by the centre of its box, in a cell that
// is at least as large as the box; the cells of edges of other sizes are smaller or larger by
// powers of two. Near edges are then in the same cell or in adjacent ones. Cells have numbers that
// grow by one along x, modulo the number of buckets, so that with the edges sorted by them three
// cells in a row are one stretch of edges, which are looked at side by side in lanes. Cells that
// share a bucket cost time but change nothing.

#include <algorithm>
#include <bit>
#include <cstdint>

#include "collision/detectors/growth.h"
#include "collision/detectors/pair_lists.h"
#include "collision/detectors/pair_sieve.h"
#include "core/bytes.h"
#include "core/parallel.h"
#include "core/registry.h"

namespace ringlet {
namespace {

constexpr int edges_a_part = 512;
constexpr int level_count = 24;  // smaller edges stand in cells larger than they need

// Boxes only choose what is looked at closely; half the digits make twice the lanes.
using Floats = std::experimental::native_simd<float>;
constexpr int float_lanes = static_cast<int>(Floats::size());

/// A cell, numbered along each axis.
struct Cell {
  std::int64_t x, y, z;
};

// The cell in which a point stands. Whatever is not finite, or so far away that cells are smaller
// than rounding errors, stands in the last one.
Cell cell_of(const Eigen::Vector3d& point, double inverse_size) {
  const auto number = [&](double coordinate) {
    constexpr double last = 1e11;
    const double scaled = coordinate * inverse_size;
    if (!(scaled > -last)) return static_cast<std::int64_t>(-last);
    return static_cast<std::int64_t>(std::floor(std::min(scaled, last)));
  };
  return {number(point.x()), number(point.y()), number(point.z())};
}

class GridDetector final : public ContactDetector {
 public:
  void bind(const Strands& strands) override {
    for (int v = 0; v + 1 < strands.vertex_count(); ++v) {
      if (strands.strand_of(v) == strands.strand_of(v + 1)) edges_.push_back(v);
    }
    buckets_ = std::bit_ceil(static_cast<std::uint32_t>(edges_.size()));
  }

  std::size_t bytes() const override {
    return bytes_of(edges_) + bytes_of(boxes_) + bytes_of(places_) + bytes_of(begins_) +
           bytes_of(sorted_);
  }

  void find(std::span<const Eigen::Vector3d> positions, double reach,
            std::vector<EdgePair>& pairs) override {
    place_boxes(positions, reach);
    choose_cells();
    sort_edges();
    const int count = static_cast<int>(edges_.size());
    std::vector<std::vector<EdgePair>> found((count + edges_a_part - 1) / edges_a_part);
    parallel_for_each(static_cast<int>(found.size()), [&](int part) {
      PairSieve sieve(positions, reach, found[part]);
      const int end = std::min(count, (part + 1) * edges_a_part);
      for (int i = part * edges_a_part; i < end; ++i) find_near(i, sieve);
      sieve.flush();
    });
    merge_sorted(found, pairs);
  }

 private:
  /// Where an edge stands, before they are sorted.
  struct Place {
    std::uint32_t bucket;
    int level;
  };
  /// The six sides of sorted boxes.
  struct Sides {
    std::array<std::vector<float>, 3> low, high;
  };

  void place_boxes(std::span<const Eigen::Vector3d> positions, double reach) {
    const int count = static_cast<int>(edges_.size());
    boxes_.resize(count);
    parallel_for_each(count, [&](int e) {
      const int v = edges_[e];
      const BoundingBox box(positions[v].cwiseMin(positions[v + 1]),
                            positions[v].cwiseMax(positions[v + 1]));
      const Eigen::Vector3d sides = Eigen::Vector3d::Constant(growth(box, reach));
      boxes_[e] = BoundingBox(box.min() - sides, box.max() + sides);
    });
  }

  // A little more than the largest side, so that rounding never makes two cells of one.
  static double extent(const BoundingBox& box) { return 1.001 * box.sizes().maxCoeff(); }

  void choose_cells() {
    double largest = 0;
    for (const BoundingBox& box : boxes_) {
      const double size = extent(box);
      if (std::isfinite(size)) largest = std::max(largest, size);
    }
    for (int level = 0; level < level_count; ++level) {
      inverse_sizes_[level] = std::ldexp(1 / largest, level);
    }
    places_.resize(boxes_.size());
    parallel_for_each(static_cast<int>(boxes_.size()), [&](int e) {
      const double times = largest / extent(boxes_[e]);
      // ilogb of what is not finite is beyond all levels.
      const int level =
          std::isfinite(times) ? std::clamp(std::ilogb(times), 0, level_count - 1) : 0;
      places_[e] = {bucket(cell_of(boxes_[e].center(), inverse_sizes_[level]), level), level};
    });
    is_occupied_.fill(false);
    for (const Place& place : places_) is_occupied_[place.level] = true;
  }

  std::uint32_t bucket(const Cell& cell, int level) const {
    const auto number = static_cast<std::uint32_t>(cell.x) +
                        row_stride * static_cast<std::uint32_t>(cell.y) +
                        layer_stride * static_cast<std::uint32_t>(cell.z) +
                        level_stride * static_cast<std::uint32_t>(level);
    return number & (buckets_ - 1);
  }

  // A counting sort, which leaves edges of one bucket in their order.
  void sort_edges() {
    begins_.assign(buckets_ + 1, 0);
    for (const Place& place : places_) ++begins_[place.bucket + 1];
    for (std::uint32_t b = 0; b < buckets_; ++b) begins_[b + 1] += begins_[b];
    sorted_.resize(edges_.size());
    std::vector<int> next(begins_.begin(), begins_.end() - 1);
    for (int e = 0; e < static_cast<int>(places_.size()); ++e) {
      sorted_[next[places_[e].bucket]++] = e;
    }
    const Eigen::Vector3d origin = boxes_[0].center();
    for (int c = 0; c < 3; ++c) {
      sides_.low[c].resize(sorted_.size() + float_lanes);
      sides_.high[c].resize(sorted_.size() + float_lanes);
    }
    parallel_for_each(static_cast<int>(sorted_.size()), [&](int i) {
      const BoundingBox& box = boxes_[sorted_[i]];
      for (int c = 0; c < 3; ++c) {
        const double low = box.min()[c] - origin[c], high = box.max()[c] - origin[c];
        // Rounding to floats must not shrink a box.
        const double grain = 1e-7 * std::max(std::abs(low), std::abs(high));
        sides_.low[c][i] = static_cast<float>(low - grain);
        sides_.high[c][i] = static_cast<float>(high + grain);
      }
    });
  }

  // The pairs of one edge with those behind it in its level, and with all in levels of larger
  // cells.
  void find_near(int i, PairSieve& sieve) const {
    const auto [own, level] = places_[sorted_[i]];
    // Half of the adjacent cells; those in the other half find this edge.
    look_along(i, i + 1, end_of(own), sieve);
    look_into(i, own + 1, own + 1, sieve);
    for (const std::uint32_t row :
         {row_stride, layer_stride - row_stride, layer_stride, layer_stride + row_stride}) {
      look_into(i, own + row - 1, own + row + 1, sieve);
    }
    for (int larger = 0; larger < level; ++larger) {
      if (!is_occupied_[larger]) continue;
      const Cell cell = cell_of(boxes_[sorted_[i]].center(), inverse_sizes_[larger]);
      const std::uint32_t middle = bucket(cell, larger);
      for (const std::uint32_t layer : {0u - layer_stride, 0u, layer_stride}) {
        for (const std::uint32_t row : {0u - row_stride, 0u, row_stride}) {
          look_into(i, middle + layer + row - 1, middle + layer + row + 1, sieve);
        }
      }
    }
  }

  int end_of(std::uint32_t bucket) const { return begins_[bucket + 1]; }

  // All edges in the buckets from first to last, three at most, modulo their number.
  void look_into(int i, std::uint32_t first, std::uint32_t last, PairSieve& sieve) const {
    const std::uint32_t mask = buckets_ - 1;
    if ((first & mask) + (last - first) <= mask) {
      look_along(i, begins_[first & mask], end_of(last & mask), sieve);
    } else {
      for (; first != last + 1; ++first) {
        look_along(i, begins_[first & mask], end_of(first & mask), sieve);
      }
    }
  }

  // The sorted edges from begin to end.
  void look_along(int i, int begin, int end, PairSieve& sieve) const {
    for (int j = begin; j < end; j += float_lanes) {
      auto near = overlap(0, i, j) && overlap(1, i, j) && overlap(2, i, j);
      while (std::experimental::any_of(near)) {
        const int lane = std::experimental::find_first_set(near);
        if (j + lane >= end) break;
        near[lane] = false;
        consider(edges_[sorted_[i]], edges_[sorted_[j + lane]], sieve);
      }
    }
  }

  Floats::mask_type overlap(int axis, int i, int j) const {
    using std::experimental::element_aligned;
    const std::vector<float>&low = sides_.low[axis], &high = sides_.high[axis];
    return Floats(&low[j], element_aligned) <= high[i] &&
           Floats(&high[j], element_aligned) >= low[i];
  }

  static void consider(int a, int b, PairSieve& sieve) {
    const EdgePair pair{std::min(a, b), std::max(a, b)};
    if (pair.first + 1 < pair.second) sieve.add(pair);
  }

  // Far from each other, and odd, so that the cells of a region fill the buckets evenly.
  static constexpr std::uint32_t row_stride = 2654435761u, layer_stride = 1540483477u,
                                 level_stride = 374761393u;

  std::vector<int> edges_;
  std::uint32_t buckets_ = 1;       // a power of two
  std::vector<BoundingBox> boxes_;  // of the edges, grown
  std::array<double, level_count> inverse_sizes_{};
  std::array<bool, level_count> is_occupied_{};
  std::vector<Place> places_;
  std::vector<int> begins_;  // of each bucket, in the sorted edges
  std::vector<int> sorted_;
  Sides sides_;  // of the sorted boxes, from an origin among them
};

}  // namespace

void register_grid_detector(Registry& registry);
void register_grid_detector(Registry& registry) {
  registry.of<ContactDetector>().add<NoParameters>(
      "grid", {"edges sorted by the cells of a grid, as large as they are", "", ""},
      [](const NoParameters&) { return std::make_unique<GridDetector>(); });
}

}  // namespace ringlet
