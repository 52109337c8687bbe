// Stands for the renderer where the libraries it needs were not found.

#include "core/error.h"
#include "plugins/render/renderer.h"

namespace ringlet {

void require_renderer() {
  throw Error(
      "this ringlet was built without Embree 3 and libpng, which draw pictures; install "
      "libembree-dev and libpng-dev, configure and build again");
}

Picture draw(const DrawnScene&, const Camera&, const Eigen::Vector3d&, const RenderParameters&) {
  require_renderer();
  return {};
}

void write_png(const Picture&, const std::filesystem::path&) { require_renderer(); }

}  // namespace ringlet
