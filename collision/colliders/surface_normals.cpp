#include "collision/colliders/surface_normals.h"

#include <Eigen/Geometry>
#include <map>
#include <utility>

namespace ringlet {
namespace {

using Corners = std::array<int, 3>;

// Of each vertex, the first at the same place.
std::vector<int> weld(const std::vector<Eigen::Vector3d>& vertices) {
  std::map<std::array<double, 3>, int> first_at;
  std::vector<int> welded;
  for (const Eigen::Vector3d& p : vertices) {
    const auto entry = first_at.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(welded.size()));
    welded.push_back(entry.first->second);
  }
  return welded;
}

bool has_area(const std::vector<Eigen::Vector3d>& vertices, const Corners& t) {
  const Eigen::Vector3d e = vertices[t[1]] - vertices[t[0]], f = vertices[t[2]] - vertices[t[0]];
  const double longest = std::max({e.norm(), f.norm(), (e - f).norm()});
  return e.cross(f).norm() > 1e-12 * longest * longest;
}

std::pair<int, int> edge_key(const Corners& t, int opposite) {
  return std::minmax(t[(opposite + 1) % 3], t[(opposite + 2) % 3]);
}

double angle_at(const std::vector<Eigen::Vector3d>& vertices, const Corners& t, int corner) {
  const Eigen::Vector3d e = vertices[t[(corner + 1) % 3]] - vertices[t[corner]];
  const Eigen::Vector3d f = vertices[t[(corner + 2) % 3]] - vertices[t[corner]];
  return std::atan2(e.cross(f).norm(), e.dot(f));
}

// The normals of a fold on itself may cancel; its face is then as good as any.
Eigen::Vector3d unit_or(const Eigen::Vector3d& sum, const Eigen::Vector3d& otherwise) {
  const double length = sum.norm();
  if (length > 1e-9) return sum / length;
  return otherwise;
}

}  // namespace

const Eigen::Vector3d& SurfaceTriangle::normal_at(const std::array<double, 3>& weights) const {
  for (int i = 0; i < 3; ++i) {
    if (weights[(i + 1) % 3] == 0 && weights[(i + 2) % 3] == 0) return vertex_normals[i];
  }
  for (int i = 0; i < 3; ++i) {
    if (weights[i] == 0) return edge_normals[i];
  }
  return face_normal;
}

std::vector<SurfaceTriangle> make_surface(const IndexedTriangles& mesh) {
  const std::vector<int> welded = weld(mesh.vertices);
  std::vector<Corners> kept;
  std::vector<Eigen::Vector3d> face_normals;
  std::map<std::pair<int, int>, Eigen::Vector3d> edge_sums;
  std::vector<Eigen::Vector3d> vertex_sums(mesh.vertices.size(), Eigen::Vector3d::Zero());
  for (const Corners& t : mesh.triangles) {
    const Corners corners{welded[t[0]], welded[t[1]], welded[t[2]]};
    if (!has_area(mesh.vertices, corners)) continue;
    const Eigen::Vector3d& origin = mesh.vertices[corners[0]];
    const Eigen::Vector3d normal =
        (mesh.vertices[corners[1]] - origin).cross(mesh.vertices[corners[2]] - origin).normalized();
    for (int i = 0; i < 3; ++i) {
      edge_sums.try_emplace(edge_key(corners, i), Eigen::Vector3d::Zero()).first->second += normal;
      vertex_sums[corners[i]] += angle_at(mesh.vertices, corners, i) * normal;
    }
    kept.push_back(corners);
    face_normals.push_back(normal);
  }

  std::vector<SurfaceTriangle> surface(kept.size());
  for (std::size_t n = 0; n < kept.size(); ++n) {
    surface[n].face_normal = face_normals[n];
    for (int i = 0; i < 3; ++i) {
      surface[n].corners[i] = mesh.vertices[kept[n][i]];
      surface[n].edge_normals[i] = unit_or(edge_sums.at(edge_key(kept[n], i)), face_normals[n]);
      surface[n].vertex_normals[i] = unit_or(vertex_sums[kept[n][i]], face_normals[n]);
    }
  }
  return surface;
}

}  // namespace ringlet
