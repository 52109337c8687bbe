// The signed distance of a triangle mesh from a grid (distance_grid.h): made once, and kept on disk
// if asked; faster than the exact one of "mesh" where many vertices are near the surface.

#include <spdlog/spdlog.h>

#include "collision/colliders/distance_grid_file.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct SdfParameters {
  ScenePath path;
  double resolution = 0.002;
  double depth = 0.01;
  bool cache = false;
  ColliderPlacement placement;

  static Schema<SdfParameters> schema() {
    using P = SdfParameters;
    return Schema<P>()
        .required("path", &P::path, "", any_number(), "a Wavefront .obj file, coordinates in m")
        .key("resolution", &P::resolution, "m", positive(), "side of a cell of the grid")
        .key("depth", &P::depth, "m", positive(),
             "how far below the surface a vertex still counts as inside; the grid reaches as far, "
             "on both sides")
        .key("cache", &P::cache, "", any_number(),
             "whether the grid is kept in a file beside the mesh, named as that with .sdf added; "
             "where it is outdated or damaged it is made anew")
        .include(&P::placement);
  }
};

class SdfCollider final : public Collider {
 public:
  explicit SdfCollider(const SdfParameters& parameters)
      : SdfCollider(parameters, read_obj_mesh(parameters.path.absolute)) {}

  const ColliderPlacement& placement() const override { return parameters_.placement; }
  void near(std::span<const Eigen::Vector3d> points, double reach,
            std::span<std::optional<Proximity>> found) const override {
    if (reach > grid_.band) {
      exact_.near(points, reach, parameters_.depth, found);
      return;
    }
    for (std::size_t n = 0; n < points.size(); ++n) {
      found[n] = grid_.at(points[n]);
      if (!found[n]) continue;
      const double distance = found[n]->distance;
      if (!(distance <= reach && distance >= -parameters_.depth)) found[n].reset();
    }
  }

 private:
  SdfCollider(const SdfParameters& parameters, const IndexedTriangles& mesh)
      : parameters_(parameters), exact_(mesh, parameters.path.absolute), grid_(make_grid(mesh)) {}

  DistanceGrid make_grid(const IndexedTriangles& mesh) const {
    const auto make = [&] {
      return make_distance_grid(exact_, parameters_.resolution, parameters_.depth);
    };
    if (!parameters_.cache) return make();
    const std::filesystem::path file = parameters_.path.absolute.string() + ".sdf";
    const GridOrigin origin{hash_mesh(mesh), parameters_.resolution, parameters_.depth};
    if (auto grid = read_distance_grid(file, origin)) return *std::move(grid);
    if (std::filesystem::exists(file)) {
      spdlog::warn("'{}' is outdated or damaged and is made anew", file.string());
    }
    DistanceGrid grid = make();
    write_distance_grid(grid, origin, file);
    return grid;
  }

  SdfParameters parameters_;
  MeshDistance exact_;  // for what is further away than the grid reaches
  DistanceGrid grid_;
};

}  // namespace

void register_sdf_collider(Registry& registry);
void register_sdf_collider(Registry& registry) {
  registry.of<Collider>().add<SdfParameters>(
      "sdf",
      {"a surface of triangles, whose signed distance is interpolated in a grid of cells of side h",
       "error below (k1 + k2) h^2 / 8 where the surface has curvatures k1, k2, and sqrt(3)/2 h "
       "everywhere",
       ""},
      [](const SdfParameters& parameters) { return std::make_unique<SdfCollider>(parameters); });
}

}  // namespace ringlet
