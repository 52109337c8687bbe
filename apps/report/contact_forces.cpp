#include "apps/report/contact_forces.h"

#include <algorithm>
#include <cmath>

#include "apps/report/packed_text.h"
#include "core/couplings.h"
#include "core/scene.h"
#include "core/simulation.h"

namespace ringlet {

struct ContactForces::Parts {
  explicit Parts(const Scene& scene) : simulation(scene) {}

  const Model& model() const { return simulation.model(); }

  Simulation simulation;
  Couplings couplings{model().groups};
  VertexField positions = simulation.state().positions;
  VertexField gradient{model().groups};
};

namespace {

/// Friction and the audit ask for the step before, which a frame does not hold.
void leave_out_motion(Json& collision) {
  for (const char* key : {"friction", "collider_friction"}) {
    if (collision.contains(key)) collision[key] = 0;
  }
  if (collision.contains("audit")) collision["audit"] = false;
}

}  // namespace

ContactForces::ContactForces(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ContactForces::~ContactForces() = default;

std::unique_ptr<ContactForces> ContactForces::of_scene(Json scene, const Registry& registry,
                                                       const std::filesystem::path& folder) {
  if (!scene.contains("collision") || !scene["collision"].is_object()) return nullptr;
  leave_out_motion(scene["collision"]);
  auto parts = std::make_unique<Parts>(read_scene(scene, registry, folder));
  return std::unique_ptr<ContactForces>(new ContactForces(std::move(parts)));
}

bool ContactForces::is_of(const std::vector<int>& vertex_counts) const {
  const Strands& strands = parts_->model().strands;
  bool same = strands.count() == static_cast<int>(vertex_counts.size());
  for (int strand = 0; same && strand < strands.count(); ++strand) {
    same = strands.size(strand) == vertex_counts[strand];
  }
  return same;
}

std::vector<float> ContactForces::at(const RunFrame& frame) {
  const Model& model = parts_->model();
  VertexField& x = parts_->positions;
  x.set_matrix(frame.positions);
  // A stage sees a step that ends where it began.
  CollisionStage& collision = *model.collision;
  collision.begin_step(x, frame.time, 1);
  collision.detect(x);
  parts_->couplings.clear();
  collision.add(x, &parts_->couplings);
  parts_->couplings.finish(model.free);

  VertexField& gradient = parts_->gradient;
  gradient.set_zero();
  for (int g = 0; g < model.groups.count(); ++g) {
    parts_->couplings.add_gradient(g, gradient.group(g));
  }
  std::vector<float> forces(model.strands.vertex_count());
  for (std::size_t v = 0; v < forces.size(); ++v) {
    forces[v] = static_cast<float>(gradient.get(static_cast<int>(v)).norm());
  }
  return forces;
}

std::string pack_contacts(const std::vector<std::vector<float>>& frames, double largest) {
  std::vector<std::uint8_t> bytes;
  for (const auto& frame : frames) {
    for (const float force : frame) {
      const double part = largest > 0 ? std::min(force / largest, 1.0) : 0;
      bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::sqrt(part))));
    }
  }
  return pack_text(bytes);
}

}  // namespace ringlet
