#include "apps/validate/end_moment.h"

#include <cmath>
#include <numbers>

#include "core/force.h"

namespace ringlet {
namespace {

constexpr int steps_to_full = 10;

struct EndMomentParameters {
  double moment = 0;

  static Schema<EndMomentParameters> schema() {
    return Schema<EndMomentParameters>().required("moment", &EndMomentParameters::moment, "N m",
                                                  any_number(), "about -z, at full");
  }
};

/// The angle of an edge, clockwise from +x.
double angle_of(const Eigen::Vector3d& edge) { return std::atan2(-edge.y(), edge.x()); }

class EndMoment final : public Force {
 public:
  explicit EndMoment(const EndMomentParameters& parameters) : full_moment_(parameters.moment) {}

  void bind(const Strands& strands, const StrandGroups& groups) override {
    strands_ = &strands;
    groups_ = &groups;
    angles_.resize(strands.count());
    for (int strand = 0; strand < strands.count(); ++strand) {
      const int tip = strands.first(strand + 1) - 1;
      angles_[strand] = angle_of(strands.rest_position(tip) - strands.rest_position(tip - 1));
    }
  }

  void begin_step(const StepStart& start) override {
    moment_ = std::min(moment_ + full_moment_ / steps_to_full, full_moment_);
    for (int strand = 0; strand < strands_->count(); ++strand) {
      const int tip = strands_->first(strand + 1) - 1;
      const Eigen::Vector3d edge =
          start.state.positions.get(tip) - start.state.positions.get(tip - 1);
      angles_[strand] = followed(angles_[strand], angle_of(edge));
    }
  }

  double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const override {
    double energy = 0;
    for (int lane = 0; lane < lane_count; ++lane) {
      const int strand = (*groups_)[group].strands[lane];
      if (strand < 0) continue;
      const int tip = strands_->size(strand) - 1;
      const auto at = [&](int i) {
        return Eigen::Vector3d(x[i].x[lane], x[i].y[lane], x[i].z[lane]);
      };
      const Eigen::Vector3d edge = at(tip) - at(tip - 1);
      energy -= moment_ * followed(angles_[strand], angle_of(edge));
      energy += hold_in_plane(strand, lane, x, outputs);
      if (outputs.gradient.empty()) continue;
      // grad phi = (e_y, -e_x) / |e|^2
      const double squared = edge.x() * edge.x() + edge.y() * edge.y();
      const double gx = -moment_ * edge.y() / squared, gy = moment_ * edge.x() / squared;
      outputs.gradient[tip].x[lane] += gx;
      outputs.gradient[tip].y[lane] += gy;
      outputs.gradient[tip - 1].x[lane] -= gx;
      outputs.gradient[tip - 1].y[lane] -= gy;
      if (!outputs.hessian.empty()) add_hessian(edge, tip, lane, outputs.hessian);
    }
    return energy;
  }

 private:
  /// M (z / l)^2 / 2 at every vertex.
  double hold_in_plane(int strand, int lane, std::span<const Vector3<Pack>> x,
                       GroupOutputs outputs) const {
    double energy = 0;
    for (int i = 0; i < strands_->size(strand); ++i) {
      const double length = strands_->voronoi_length(strands_->first(strand) + i);
      const double stiffness = moment_ / (length * length), z = x[i].z[lane];
      energy += 0.5 * stiffness * z * z;
      if (!outputs.gradient.empty()) outputs.gradient[i].z[lane] += stiffness * z;
      if (!outputs.hessian.empty()) outputs.hessian.block(i, 0)(2, 2)[lane] += stiffness;
    }
    return energy;
  }

  /// Not definite, but the sum of the whole potential is where it has its minimum.
  void add_hessian(const Eigen::Vector3d& edge, int tip, int lane, const GroupBands& bands) const {
    const double squared = edge.x() * edge.x() + edge.y() * edge.y();
    const double scale = -moment_ / (squared * squared);
    const double diagonal = scale * 2 * edge.x() * edge.y();
    const double mixed = scale * (edge.x() * edge.x() - edge.y() * edge.y());
    const auto add = [&](Matrix3<Pack>& block, double sign) {
      block(0, 0)[lane] -= sign * diagonal;
      block(0, 1)[lane] += sign * mixed;
      block(1, 0)[lane] += sign * mixed;
      block(1, 1)[lane] += sign * diagonal;
    };
    add(bands.block(tip, 0), 1);
    add(bands.block(tip - 1, 0), 1);
    add(bands.block(tip, 1), -1);
  }

  /// The angle, less whole turns, that is nearest to the last one.
  static double followed(double last, double angle) {
    return last + std::remainder(angle - last, 2 * std::numbers::pi);
  }

  double full_moment_, moment_ = 0;  // N m
  const Strands* strands_ = nullptr;
  const StrandGroups* groups_ = nullptr;
  std::vector<double> angles_;  // of the last edges when the step began, rad
};

}  // namespace

void register_end_moment(Registry& registry) {
  registry.of<Force>().add<EndMomentParameters>(
      "end_moment", {"a moment on the last edge of each strand", "-M phi", ""},
      [](const EndMomentParameters& parameters) {
        return std::make_unique<EndMoment>(parameters);
      });
}

}  // namespace ringlet
