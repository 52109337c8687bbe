#include "core/sources/blue_noise.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <queue>

#include "core/random.h"

namespace ringlet {
namespace {

constexpr int samples_per_point = 5;

std::vector<Eigen::Vector3d> uniform_samples(int count, double lowest, unsigned seed) {
  Random random(seed);
  std::vector<Eigen::Vector3d> samples(count);
  for (Eigen::Vector3d& sample : samples) {
    // The area of a sphere between two heights is proportional to their difference (Archimedes).
    const double height = random.uniform(lowest, 1);
    const double longitude = random.uniform(0, 2 * std::numbers::pi);
    const double radius = std::sqrt(1 - height * height);
    sample = {radius * std::cos(longitude), height, radius * std::sin(longitude)};
  }
  return samples;
}

// Points sorted by the cells of a grid as wide as the reach, so that all points in reach of one
// are in the 27 cells around it. Cells in a row along x are neighbours in the order.
class SortedGrid {
 public:
  SortedGrid(const std::vector<Eigen::Vector3d>& points, double cell)
      : points_(points), cell_(cell), row_(static_cast<std::int64_t>(2 / cell) + 3) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      order_.push_back({key(cell_of(points[i])), static_cast<int>(i)});
    }
    std::sort(order_.begin(), order_.end());
  }

  template <class Visit>
  void for_each_near(int point, const Visit& visit) const {
    const Cell centre = cell_of(points_[point]);
    for (std::int64_t z = centre.z - 1; z <= centre.z + 1; ++z) {
      for (std::int64_t y = centre.y - 1; y <= centre.y + 1; ++y) {
        const std::int64_t last = key({centre.x + 1, y, z});
        auto entry =
            std::lower_bound(order_.begin(), order_.end(), Entry{key({centre.x - 1, y, z}), -1});
        for (; entry != order_.end() && entry->key <= last; ++entry) {
          if (entry->point != point) visit(entry->point);
        }
      }
    }
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
  struct Entry {
    std::int64_t key;
    int point;
    auto operator<=>(const Entry&) const = default;
  };

  Cell cell_of(const Eigen::Vector3d& p) const {
    const auto index = [&](double x) { return static_cast<std::int64_t>((x + 1) / cell_) + 1; };
    return {index(p.x()), index(p.y()), index(p.z())};
  }
  std::int64_t key(const Cell& cell) const { return (cell.z * row_ + cell.y) * row_ + cell.x; }

  const std::vector<Eigen::Vector3d>& points_;
  double cell_;
  std::int64_t row_;
  std::vector<Entry> order_;
};

struct Neighbour {
  int sample;
  double crowding;  // (1 - distance / spacing)^8
};

// The samples nearer than the spacing of each sample, in one list; those of sample i are
// [first[i], first[i + 1]).
struct Neighbourhoods {
  std::vector<std::size_t> first{0};
  std::vector<Neighbour> all;

  Neighbourhoods(const std::vector<Eigen::Vector3d>& samples, double spacing) {
    const SortedGrid grid(samples, spacing);
    for (int i = 0; i < static_cast<int>(samples.size()); ++i) {
      grid.for_each_near(i, [&](int j) {
        const double nearness = 1 - (samples[i] - samples[j]).norm() / spacing;
        if (nearness > 0) all.push_back({j, std::pow(nearness, 8)});
      });
      first.push_back(all.size());
    }
  }
  template <class Visit>
  void for_each(int sample, const Visit& visit) const {
    for (std::size_t n = first[sample]; n < first[sample + 1]; ++n) visit(all[n]);
  }
};

// Marks the samples that stay.
std::vector<char> eliminate(const Neighbourhoods& neighbourhoods, int samples, int count) {
  std::vector<double> crowding(samples, 0.0);
  std::priority_queue<std::pair<double, int>> most_crowded;
  for (int i = 0; i < samples; ++i) {
    neighbourhoods.for_each(i, [&](const Neighbour& n) { crowding[i] += n.crowding; });
    most_crowded.push({crowding[i], i});
  }
  std::vector<char> stays(samples, 1);
  for (int left = samples; left > count;) {
    const auto [value, sample] = most_crowded.top();
    most_crowded.pop();
    if (value > crowding[sample]) {  // it became less crowded since it was queued
      most_crowded.push({crowding[sample], sample});
      continue;
    }
    stays[sample] = 0;
    --left;
    neighbourhoods.for_each(sample, [&](const Neighbour& n) { crowding[n.sample] -= n.crowding; });
  }
  return stays;
}

}  // namespace

double hexagonal_spacing(double area, int count) {
  return std::sqrt(2 * area / (std::sqrt(3.0) * count));
}

std::vector<Eigen::Vector3d> blue_noise_on_sphere(int count, double lowest, unsigned seed) {
  const auto samples = uniform_samples(samples_per_point * count, lowest, seed);
  const double spacing = hexagonal_spacing(2 * std::numbers::pi * (1 - lowest), count);
  const auto stays =
      eliminate(Neighbourhoods(samples, spacing), static_cast<int>(samples.size()), count);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (stays[i]) points.push_back(samples[i]);
  }
  return points;
}

}  // namespace ringlet
