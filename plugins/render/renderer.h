#pragma once

#include <vector>

#include "plugins/render/camera.h"
#include "plugins/render/picture.h"
#include "plugins/render/render_parameters.h"
#include "plugins/render/shapes.h"
#include "plugins/render/strand_shapes.h"

namespace ringlet {

/// What is to be seen.
struct DrawnScene {
  StrandShapes strands;
  std::vector<DrawnShape> shapes;
};

/// Throws Error if this build cannot draw, and says what it lacks.
void require_renderer();

/// Draws a scene by ray tracing; `up`, of length 1, points to the sky. The same input gives the
/// same picture, to the bit, on any number of threads.
Picture draw(const DrawnScene& subject, const Camera& camera, const Eigen::Vector3d& up,
             const RenderParameters& parameters);

}  // namespace ringlet
