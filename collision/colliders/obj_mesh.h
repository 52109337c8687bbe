#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <vector>

namespace ringlet {

/// Triangles over shared vertices.
struct IndexedTriangles {
  std::vector<Eigen::Vector3d> vertices;      ///< m
  std::vector<std::array<int, 3>> triangles;  ///< indices of vertices
};

/// Reads the v and f lines of a Wavefront .obj file; what else stands there is ignored. Polygons
/// become fans of triangles. Throws Error with file and line for a number that is none or is not
/// finite, an index that is none or names no vertex before it, and a face of fewer than three
/// vertices; also if the file cannot be read or has no face.
IndexedTriangles read_obj_mesh(const std::filesystem::path& path);

}  // namespace ringlet
