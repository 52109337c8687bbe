#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plugins/render/renderer.h"
#include "plugins/run_frames.h"

namespace ringlet {

/// Some frames of a run as subjects of pictures, seen by one camera.
class RunScenery {
 public:
  /// `numbers` are those of the frames. Reads all of them, so that the camera can have all in view.
  /// Throws Error if one cannot be read.
  RunScenery(RunFrames& frames, std::vector<int> numbers, const Json& scene,
             const RenderParameters& parameters, const Registry& registry);

  int count() const { return static_cast<int>(numbers_.size()); }
  int step(int i) const { return steps_[i]; }
  /// From frame to frame, on average; of a single frame 1 s.
  double seconds_each() const;
  /// The i-th of the frames.
  DrawnScene subject(int i);
  const Camera& camera() const { return camera_; }
  const Eigen::Vector3d& up() const { return up_; }
  /// What cannot be shown.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  void read_shapes(const Json& scene, const Registry& registry);

  struct MovingShape {
    DrawnShape shape;
    std::vector<Eigen::Isometry3d> placements;  // one a frame
  };
  RunFrames& frames_;
  std::vector<int> numbers_, steps_;
  std::vector<double> times_;  // s
  std::vector<MovingShape> shapes_;
  Eigen::Vector3d up_;
  Camera camera_;
  std::vector<DrawnShape> ground_;  // or nothing
  std::vector<std::string> notes_;
};

/// What is up in a scene: the direction that the parameters ask for, or against its gravity, or +y.
Eigen::Vector3d up_of(const Json& scene, const RenderParameters& parameters);

}  // namespace ringlet
