#include "solvers/integrators/first_guess.h"

#include <vector>

#include "core/parallel.h"
#include "core/simulation.h"

namespace ringlet {
namespace {

/// The motion of the strands of a group, a lane each.
struct LaneMotion {
  Matrix3<Pack> rotation;
  Vector3<Pack> translation;
  Pack carried_rows = 0;  ///< of each strand; 0: it stays

  void set(int lane, int vertices, const Eigen::Isometry3d& moved) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) rotation(r, c)[lane] = moved.linear()(r, c);
    }
    translation.x[lane] = moved.translation().x();
    translation.y[lane] = moved.translation().y();
    translation.z[lane] = moved.translation().z();
    carried_rows[lane] = vertices;
  }
  void carry(std::span<const Vector3<Pack>> from, std::span<Vector3<Pack>> to) const {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Mask carried = Pack(static_cast<double>(i)) < carried_rows;
      to[i] = select(carried, rotation * from[i] + translation, from[i]);
    }
  }
};

/// What each strand is carried by: the motion of the first of its pins that has one.
std::vector<const Eigen::Isometry3d*> find_carriers(const Model& model, Displacements& in_step) {
  std::vector<const Eigen::Isometry3d*> carriers(model.strands.count(), nullptr);
  for (const Pin& pin : model.pins) {
    const Eigen::Isometry3d*& carrier = carriers[model.strands.strand_of(pin.vertex)];
    if (carrier == nullptr && !pin.motion.empty()) carrier = &in_step.by(pin.motion);
  }
  return carriers;
}

}  // namespace

void carry_strands_with_pins(const Model& model, const VertexField& x_n, double time,
                             double time_end, VertexField& x) {
  Displacements in_step(model.motions, time, time_end);
  const auto carriers = find_carriers(model, in_step);
  parallel_for_each(model.groups.count(), [&](int g) {
    LaneMotion motion{Matrix3<Pack>::zero(), {0, 0, 0}};
    for (int lane = 0; lane < lane_count; ++lane) {
      const int strand = model.groups[g].strands[lane];
      if (strand < 0 || carriers[strand] == nullptr) continue;
      motion.set(lane, model.strands.size(strand), *carriers[strand]);
    }
    motion.carry(x_n.group(g), x.group(g));
  });
  place_pins(model, time_end, x);
}

}  // namespace ringlet
