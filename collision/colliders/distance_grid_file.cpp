// Layout, little-endian: the eight bytes "RLSDF 1\n", GridOrigin, origin of the grid, numbers of
// blocks along the axes (3 x int32), number of blocks kept (int32), block_at, distances, and the
// hash of all that.

#include "collision/colliders/distance_grid_file.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

#include "core/atomic_file.h"
#include "core/readers/file_bytes.h"

namespace ringlet {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view magic = "RLSDF 1\n";

/// Fowler, Noll and Vo's FNV-1a with words of eight bytes instead of bytes.
std::uint64_t hash(std::string_view bytes, std::uint64_t seed = 14695981039346656037ull) {
  for (std::size_t n = 0; n < bytes.size(); n += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + n, std::min<std::size_t>(8, bytes.size() - n));
    seed = (seed ^ word) * 1099511628211ull;
    seed ^= seed >> 32;
  }
  return seed;
}

template <class T>
std::string_view chars_of(const T* first, std::size_t count) {
  return {reinterpret_cast<const char*>(first), count * sizeof(T)};
}

template <class T>
void append(std::string& bytes, const T& value) {
  bytes += chars_of(&value, 1);
}

/// Copies numbers from the front of the bytes; false if these are too few.
template <class T>
bool take(std::string_view& bytes, T* first, std::size_t count) {
  const std::size_t size = count * sizeof(T);
  if (bytes.size() < size) return false;
  std::memcpy(first, bytes.data(), size);
  bytes.remove_prefix(size);
  return true;
}

std::optional<DistanceGrid> grid_of(std::string_view bytes, const GridOrigin& expected) {
  GridOrigin origin{};
  DistanceGrid grid;
  std::int32_t kept = 0;
  if (!take(bytes, &origin, 1) || !(origin == expected)) return {};
  if (!take(bytes, grid.origin.data(), 3) || !take(bytes, &grid.blocks, 1)) return {};
  if (!take(bytes, &kept, 1)) return {};
  grid.resolution = origin.resolution;
  grid.band = origin.band;
  const auto [nx, ny, nz] = grid.blocks;
  grid.block_at.resize(std::size_t(nx) * ny * nz);
  grid.distances.resize(std::size_t(kept) * DistanceGrid::block_nodes);
  if (!take(bytes, grid.block_at.data(), grid.block_at.size())) return {};
  if (!take(bytes, grid.distances.data(), grid.distances.size())) return {};
  return grid;
}

}  // namespace

std::uint64_t hash_mesh(const IndexedTriangles& mesh) {
  static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
  const std::uint64_t vertices = hash(chars_of(mesh.vertices.data(), mesh.vertices.size()));
  return hash(chars_of(mesh.triangles.data(), mesh.triangles.size()), vertices);
}

std::optional<DistanceGrid> read_distance_grid(const std::filesystem::path& file,
                                               const GridOrigin& origin) {
  if (!std::filesystem::exists(file)) return {};
  const std::string content = read_bytes(file);
  if (content.size() < magic.size() + sizeof(std::uint64_t) || !content.starts_with(magic)) {
    return {};
  }
  std::string_view bytes(content);
  std::uint64_t expected_hash = 0;
  std::memcpy(&expected_hash, bytes.data() + bytes.size() - sizeof(expected_hash),
              sizeof(expected_hash));
  bytes.remove_suffix(sizeof(expected_hash));
  if (hash(bytes) != expected_hash) return {};
  bytes.remove_prefix(magic.size());
  return grid_of(bytes, origin);
}

void write_distance_grid(const DistanceGrid& grid, const GridOrigin& origin,
                         const std::filesystem::path& file) {
  std::string bytes(magic);
  append(bytes, origin);
  append(bytes, grid.origin);
  append(bytes, grid.blocks);
  append(bytes, static_cast<std::int32_t>(grid.distances.size() / DistanceGrid::block_nodes));
  bytes += chars_of(grid.block_at.data(), grid.block_at.size());
  bytes += chars_of(grid.distances.data(), grid.distances.size());
  append(bytes, hash(bytes));
  AtomicFile output(file);
  output.stream() << bytes;
  output.commit();
}

}  // namespace ringlet
