#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "collision/colliders/distance_grid.h"

namespace ringlet {

/// What a kept grid was made of: it is outdated if any of this has changed.
struct GridOrigin {
  std::uint64_t mesh_hash;
  double resolution, band;  // m

  friend bool operator==(const GridOrigin&, const GridOrigin&) = default;
};

/// A hash of all coordinates and triangles of a mesh.
std::uint64_t hash_mesh(const IndexedTriangles& mesh);

/// The grid in a file, or nothing if there is none, it is of another origin, or it is damaged.
std::optional<DistanceGrid> read_distance_grid(const std::filesystem::path& file,
                                               const GridOrigin& origin);
/// The file appears whole or not at all. Throws Error if it cannot be written.
void write_distance_grid(const DistanceGrid& grid, const GridOrigin& origin,
                         const std::filesystem::path& file);

}  // namespace ringlet
