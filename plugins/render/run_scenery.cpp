#include "plugins/render/run_scenery.h"

#include <algorithm>
#include <limits>

namespace ringlet {
namespace {

/// Sees what is added: the camera that frames it, and how low it reaches.
class Bounds {
 public:
  Bounds(const RenderParameters& parameters, const Eigen::Vector3d& up)
      : framing_(parameters.camera.direction, up, parameters.camera.field_of_view, parameters.width,
                 parameters.height),
        up_(up) {}

  void add(const Eigen::Vector3d& centre, double radius) {
    framing_.add(centre, radius);
    lowest_ = std::min(lowest_, up_.dot(centre) - radius);
  }
  void add(const Ball& ball) { add(ball.centre, ball.radius); }
  void add(const Capsule& capsule) {
    add(capsule.from, capsule.radius);
    add(capsule.to, capsule.radius);
  }
  void add(const Plane&) { has_plane_ = true; }
  void add(const Triangles& triangles) {
    for (const Eigen::Vector3d& vertex : triangles.vertices) add(vertex, 0);
  }

  Camera camera() const { return framing_.camera(); }
  std::vector<DrawnShape> ground() const {
    if (has_plane_ || lowest_ == std::numeric_limits<double>::infinity()) return {};
    return {Plane{lowest_ * up_, up_}};
  }

 private:
  Framing framing_;
  Eigen::Vector3d up_;
  double lowest_ = std::numeric_limits<double>::infinity();
  bool has_plane_ = false;
};

Camera given_camera(const RenderParameters& parameters, const Eigen::Vector3d& up) {
  const CameraParameters& camera = parameters.camera;
  return {*camera.position,     *camera.target,   up,
          camera.field_of_view, parameters.width, parameters.height};
}

}  // namespace

Eigen::Vector3d up_of(const Json& scene, const RenderParameters& parameters) {
  if (parameters.camera.up) return *parameters.camera.up;
  for (const Json& force : scene.value("forces", Json::array())) {
    if (force.value("type", "") != "gravity") continue;
    const Json& a = force.at("acceleration");
    const Eigen::Vector3d gravity(a.at(0), a.at(1), a.at(2));
    if (gravity.norm() > 0) return -gravity.normalized();
  }
  return Eigen::Vector3d::UnitY();
}

RunScenery::RunScenery(RunFrames& frames, std::vector<int> numbers, const Json& scene,
                       const RenderParameters& parameters, const Registry& registry)
    : frames_(frames),
      numbers_(std::move(numbers)),
      up_(up_of(scene, parameters)),
      camera_(Bounds(parameters, up_).camera()) {
  Bounds bounds(parameters, up_);
  for (const int number : numbers_) {
    const RunFrame frame = frames_.read(number);
    for (Eigen::Index v = 0; v < frame.positions.cols(); ++v) {
      bounds.add(frame.positions.col(v), frames_.radii()[static_cast<std::size_t>(v)]);
    }
    times_.push_back(frame.time);
    steps_.push_back(frame.step);
  }
  read_shapes(scene, registry);
  for (const MovingShape& moving : shapes_) {
    for (const Eigen::Isometry3d& placement : moving.placements) {
      std::visit([&](const auto& shape) { bounds.add(shape); }, moved(moving.shape, placement));
    }
  }
  camera_ = parameters.camera.position ? given_camera(parameters, up_) : bounds.camera();
  if (parameters.ground) ground_ = bounds.ground();
}

void RunScenery::read_shapes(const Json& scene, const Registry& registry) {
  for (PlacedCollider& collider : place_colliders(scene, registry, times_, notes_)) {
    try {
      shapes_.push_back({shape_of(collider), std::move(collider.placements)});
    } catch (const std::exception& error) {
      notes_.push_back(not_shown(collider.type, error.what()));
    }
  }
}

double RunScenery::seconds_each() const {
  const double span = times_.back() - times_.front();
  return span > 0 ? span / (count() - 1) : 1;
}

DrawnScene RunScenery::subject(int i) {
  DrawnScene subject{
      {frames_.vertex_counts(), frames_.radii(), frames_.read(numbers_[i]).positions}, ground_};
  for (const MovingShape& moving : shapes_) {
    subject.shapes.push_back(moved(moving.shape, moving.placements[i]));
  }
  return subject;
}

}  // namespace ringlet
