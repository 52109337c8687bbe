// The rest state with which strands do not sag: the forces of their elements balance the loads in
// the shape that they are given in.
#include <spdlog/spdlog.h>

#include <algorithm>

#include "core/parallel.h"
#include "core/registry.h"
#include "core/rest_state.h"
#include "core/rest_states/loads.h"
#include "core/rest_states/strand_fit.h"

namespace ringlet {
namespace {

struct SagFreeParameters {
  std::vector<std::string> forces{"gravity"};

  static Schema<SagFreeParameters> schema() {
    return Schema<SagFreeParameters>().key(
        "forces", &SagFreeParameters::forces, "", any_number(),
        "the forces of the scene that the strands hold, as they are at the beginning");
  }
};

VertexField rest_positions(const Model& model) {
  std::vector<Eigen::Vector3d> positions(model.strands.vertex_count());
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    positions[v] = model.strands.rest_position(v);
  }
  return positions_with_pads(model.groups, positions);
}

/// What became of a strand.
struct Outcome {
  bool is_free = false;
  bool is_stable = true;
  int without_rest = 0;
};

void tell(const RestReport& report) {
  if (report.not_held > 0) {
    spdlog::warn(
        "sag_free: {} of {} strands are not held, and start with up to {:.3g} m/s^2: with fewer "
        "than three pinned vertices a strand turns about its root, and a straight hinge has no "
        "plane in which to hold a load",
        report.not_held, report.strands, report.acceleration);
  }
  if (report.unstable > 0) {
    spdlog::warn(
        "sag_free: {} of {} strands are held in an equilibrium that is not stable: they are too "
        "soft for their length and shape",
        report.unstable, report.strands);
  }
  if (report.without_rest > 0) {
    spdlog::warn(
        "sag_free: {} elements hold with a rest angle that no shape has, most of them beyond "
        "straight: where they pass straight their force will jump",
        report.without_rest);
  }
}

class SagFree final : public RestState {
 public:
  explicit SagFree(SagFreeParameters parameters) : parameters_(std::move(parameters)) {}

  RestReport choose(Model& model) const override {
    const VertexField x = rest_positions(model);
    VertexField gradient = gradient_of_loads(model, x, parameters_.forces);
    const std::vector<double> loads = largest_accelerations(model, gradient);
    const double largest_load = *std::max_element(loads.begin(), loads.end());
    if (largest_load == 0) return {};
    const std::vector<Outcome> outcomes = hold_all(model, x, gradient);
    for (int g = 0; g < model.groups.count(); ++g) {
      add_gradient_of_holding_energies(model, g, x, gradient);
    }
    const std::vector<double> left = largest_accelerations(model, gradient);

    // Not to be held shows at once; what is below is the rounding of the rest angles of stiff
    // strands.
    const double held = 1e-3 * largest_load;
    RestReport report;
    for (int strand = 0; strand < model.strands.count(); ++strand) {
      const Outcome& outcome = outcomes[strand];
      const bool is_held = left[strand] <= held;
      report.strands += outcome.is_free ? 1 : 0;
      report.not_held += is_held ? 0 : 1;
      report.unstable += is_held && !outcome.is_stable ? 1 : 0;
      report.without_rest += outcome.without_rest;
      report.acceleration = std::max(report.acceleration, left[strand]);
    }
    tell(report);
    return report;
  }

 private:
  static std::vector<Outcome> hold_all(Model& model, const VertexField& x,
                                       const VertexField& loads) {
    std::vector<Outcome> outcomes(model.strands.count());
    VertexField gradient = loads;
    // The strands of a group share the packs in which their rest states lie.
    parallel_for_each(model.groups.count(),
                      [&](int g) { hold_group(model, g, x, gradient, outcomes); });
    return outcomes;
  }

  static void hold_group(Model& model, int g, const VertexField& x, VertexField& gradient,
                         std::vector<Outcome>& outcomes) {
    std::vector<StrandFit> fits;
    for (const int strand : model.groups[g].strands) {
      if (strand >= 0) fits.emplace_back(model, strand, x);
    }
    for (StrandFit& fit : fits) fit.hold(gradient);
    // In lanes the torsion of what is nearly straight is rounded in another way.
    add_gradient_of_holding_energies(model, g, x, gradient);
    for (StrandFit& fit : fits) {
      Outcome& outcome = outcomes[fit.strand()];
      outcome = {fit.is_free(), true, fit.hold(gradient)};
      if (outcome.is_free) outcome.is_stable = fit.is_stable();
    }
  }

  SagFreeParameters parameters_;
};

}  // namespace

void register_sag_free(Registry& registry);
void register_sag_free(Registry& registry) {
  registry.of<RestState>().add<SagFreeParameters>(
      "sag_free",
      {"rest lengths and angles with which the strands are in equilibrium in the shape that they "
       "are given in, as far as their elements can hold it; what they cannot is told",
       "min over the rest states of sum_i m_i |a_i|^2", "Gauss's principle of least constraint"},
      [](const SagFreeParameters& parameters) { return std::make_unique<SagFree>(parameters); });
}

}  // namespace ringlet
