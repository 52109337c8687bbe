#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/registry.h"
#include "plugins/run_frames.h"

namespace ringlet {

/// How hard contacts push each vertex of a frame, as the collision stage of its scene says.
class ContactForces {
 public:
  /// Nothing if the scene has no collision. Throws Error if the scene cannot be made again, since a
  /// plugin or a file is not there any more.
  static std::unique_ptr<ContactForces> of_scene(Json scene, const Registry& registry,
                                                 const std::filesystem::path& folder);
  /// Whether frames with so many vertices a strand are of the scene.
  bool is_of(const std::vector<int>& vertex_counts) const;
  ~ContactForces();
  ContactForces(const ContactForces&) = delete;
  ContactForces& operator=(const ContactForces&) = delete;

  /// N, one a vertex, without friction. Throws Error if the stage cannot tell.
  std::vector<float> at(const RunFrame& frame);

 private:
  struct Parts;
  explicit ContactForces(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// Numbers >= 0 of some frames as text, a byte each: b stands for `largest` (b / 255)^2.
std::string pack_contacts(const std::vector<std::vector<float>>& frames, double largest);

}  // namespace ringlet
