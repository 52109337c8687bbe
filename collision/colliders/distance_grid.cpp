#include "collision/colliders/distance_grid.h"

#include "core/error.h"
#include "core/parallel.h"

namespace ringlet {
namespace {

constexpr double most_blocks = 1e8;

using BlockPlace = std::array<int, 3>;

BlockPlace place_of(const DistanceGrid& grid, int block) {
  const auto [nx, ny, nz] = grid.blocks;
  return {block % nx, block / nx % ny, block / nx / ny};
}

double block_size(const DistanceGrid& grid) { return DistanceGrid::block_cells * grid.resolution; }

Eigen::Vector3d corner(const DistanceGrid& grid, int block) {
  const BlockPlace place = place_of(grid, block);
  return grid.origin + block_size(grid) * Eigen::Vector3d(place[0], place[1], place[2]);
}

/// A grid that covers a box, without blocks.
DistanceGrid cover(const BoundingBox& box, double resolution, double band) {
  DistanceGrid grid;
  grid.resolution = resolution;
  grid.band = band;
  grid.origin = box.min() - Eigen::Vector3d::Constant(band + resolution);
  const Eigen::Vector3d size = box.max() - grid.origin + Eigen::Vector3d::Constant(band);
  const Eigen::Array3d counts = (size / block_size(grid)).array().floor() + 1;
  if (!(counts.prod() < most_blocks)) {
    throw Error("a signed distance grid with a resolution of " + std::to_string(resolution) +
                " m would have too many blocks; make it at least " +
                std::to_string(resolution * std::cbrt(counts.prod() / most_blocks)) + " m");
  }
  for (int axis = 0; axis < 3; ++axis) grid.blocks[axis] = static_cast<int>(counts[axis]);
  grid.block_at.assign(static_cast<std::size_t>(counts.prod()), -1);
  return grid;
}

double half_diagonal(const DistanceGrid& grid) { return std::sqrt(0.75) * block_size(grid); }

// Numbers the blocks near the surface; returns them.
std::vector<int> keep_near_blocks(const MeshDistance& mesh, DistanceGrid& grid) {
  std::vector<char> is_near(grid.block_at.size());
  const double reach = (1 + 1e-6) * (grid.band + half_diagonal(grid));
  parallel_for_each(static_cast<int>(is_near.size()), [&](int block) {
    const Eigen::Vector3d centre =
        corner(grid, block) + Eigen::Vector3d::Constant(block_size(grid) / 2);
    std::optional<Proximity> found;
    mesh.near({&centre, 1}, reach, reach, {&found, 1});
    is_near[block] = found.has_value() ? 1 : 0;
  });
  std::vector<int> near;
  for (int block = 0; block < static_cast<int>(is_near.size()); ++block) {
    if (is_near[block] == 0) continue;
    grid.block_at[block] = static_cast<int>(near.size());
    near.push_back(block);
  }
  return near;
}

void measure_block(const MeshDistance& mesh, const DistanceGrid& grid, int block,
                   std::span<float> distances) {
  constexpr int side = DistanceGrid::block_side;
  const double reach = (1 + 1e-6) * (grid.band + 2 * half_diagonal(grid));
  std::array<Eigen::Vector3d, side> row;
  std::array<std::optional<Proximity>, side> found;
  for (int first = 0; first < DistanceGrid::block_nodes; first += side) {
    const int j = first / side % side, k = first / side / side;
    for (int i = 0; i < side; ++i) {
      row[i] = corner(grid, block) + grid.resolution * Eigen::Vector3d(i, j, k);
    }
    mesh.near(row, reach, reach, found);
    for (int i = 0; i < side; ++i) distances[first + i] = static_cast<float>(found[i]->distance);
  }
}

}  // namespace

std::optional<Proximity> DistanceGrid::at(const Eigen::Vector3d& point) const {
  const Eigen::Array3d place = (point - origin).array() / resolution;
  const Eigen::Array3d cells = place.floor();
  std::array<int, 3> block{}, cell{};
  for (int axis = 0; axis < 3; ++axis) {
    if (!(cells[axis] >= 0 && cells[axis] < double(blocks[axis]) * block_cells)) return {};
    const int number = static_cast<int>(cells[axis]);
    block[axis] = number / block_cells;
    cell[axis] = number % block_cells;
  }
  const auto rows = static_cast<std::size_t>(blocks[1]) * block[2] + block[1];
  const int kept = block_at[rows * blocks[0] + block[0]];
  if (kept < 0) return {};
  const float* node = &distances[static_cast<std::size_t>(kept) * block_nodes + cell[0] +
                                 block_side * (cell[1] + block_side * cell[2])];
  const Eigen::Array3d t = place - cells;
  double distance = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (int corner = 0; corner < 8; ++corner) {
    const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    const double d = node[i + block_side * (j + block_side * k)];
    const double x = i == 1 ? t.x() : 1 - t.x(), y = j == 1 ? t.y() : 1 - t.y(),
                 z = k == 1 ? t.z() : 1 - t.z();
    distance += x * y * z * d;
    gradient += d * Eigen::Vector3d((2 * i - 1) * y * z, (2 * j - 1) * x * z, (2 * k - 1) * x * y);
  }
  const double length = gradient.norm();
  // Half-way between two sides of a body any direction is as good.
  if (!(length > 1e-9 * resolution)) return Proximity{distance, Eigen::Vector3d::UnitZ()};
  return Proximity{distance, gradient / length};
}

DistanceGrid make_distance_grid(const MeshDistance& mesh, double resolution, double band) {
  DistanceGrid grid = cover(mesh.box(), resolution, band);
  const std::vector<int> near = keep_near_blocks(mesh, grid);
  grid.distances.resize(near.size() * DistanceGrid::block_nodes);
  parallel_for_each(static_cast<int>(near.size()), [&](int n) {
    const std::size_t first = static_cast<std::size_t>(n) * DistanceGrid::block_nodes;
    measure_block(mesh, grid, near[n],
                  std::span(grid.distances).subspan(first, DistanceGrid::block_nodes));
  });
  return grid;
}

}  // namespace ringlet
