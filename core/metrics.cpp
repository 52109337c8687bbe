#include "core/metrics.h"

#include <algorithm>
#include <numeric>

#include "core/kinetic_energy.h"
#include "core/parallel.h"
#include "core/registry.h"

namespace ringlet {
namespace {

RestDistance measure_strand(const Strands& strands, const VertexField& positions, int strand) {
  RestDistance distance;
  const double length = strands.strand_length(strand);
  for (int v = strands.first(strand); v < strands.first(strand + 1); ++v) {
    const double relative = (positions.get(v) - strands.rest_position(v)).norm() / length;
    distance.mean += relative;
    distance.max = std::max(distance.max, relative);
  }
  return distance;
}

std::vector<Metric> list_energies(std::vector<std::string> types,
                                  const std::vector<std::string>& left_out) {
  const std::size_t measured = types.size();
  types.insert(types.end(), left_out.begin(), left_out.end());
  std::vector<Metric> metrics;
  for (std::size_t i = 0; i < types.size(); ++i) {
    const auto earlier = std::count(types.begin(), types.begin() + static_cast<long>(i), types[i]);
    std::string name = "energy_" + types[i];
    if (earlier > 0) name.append("_").append(std::to_string(earlier + 1));
    metrics.push_back({std::move(name), [i, measured](const StepSample& sample) {
                         return i < measured ? sample.report.energies.at(i) : 0.0;
                       }});
  }
  return metrics;
}

}  // namespace

RestDistance measure_rest_distance(const Model& model, const VertexField& positions) {
  const Strands& strands = model.strands;
  std::vector<RestDistance> of_strands(strands.count());
  parallel_for_each(strands.count(), [&](int strand) {
    of_strands[strand] = measure_strand(strands, positions, strand);
  });
  RestDistance all;
  for (const RestDistance& one : of_strands) {
    all.mean += one.mean / strands.vertex_count();
    all.max = std::max(all.max, one.max);
  }
  return all;
}

double elastic_energy(const Model& model, const VertexField& positions) {
  double sum = parallel_sum(model.groups.count(), [&](int g) {
    double of_group = 0;
    for (const auto& energy : model.energies) {
      of_group += naming(*energy, [&] { return energy->add(g, positions.group(g), {}); });
    }
    return of_group;
  });
  for (const auto& coupling : model.couplings) {
    sum += naming(*coupling, [&] { return coupling->add(positions, nullptr); });
  }
  return sum;
}

EnergyWatch::EnergyWatch(const Model& model, const State& state)
    : last_(elastic_energy(model, state.positions) + kinetic_energy(model, state.velocities)),
      largest_(last_) {}

double EnergyWatch::rise_after(const StepReport& report) {
  const double energy = std::accumulate(report.energies.begin(), report.energies.end(),
                                        report.kinetic_energy + report.contact_energy);
  largest_ = std::max(largest_, energy);
  if (largest_ > 0) rise_ = std::max(rise_, (energy - last_) / largest_);
  last_ = energy;
  return rise_;
}

std::vector<Metric> list_metrics(const std::vector<std::string>& energy_types,
                                 const std::vector<std::string>& left_out) {
  using Sample = const StepSample&;
  std::vector<Metric> metrics{
      {"step", [](Sample s) { return s.step; }},
      {"time", [](Sample s) { return s.time; }},
      {"newton_iterations", [](Sample s) { return s.report.newton_iterations; }},
      {"newton_converged", [](Sample s) { return s.report.newton_converged; }},
      {"newton_update", [](Sample s) { return s.report.newton_update; }},
      {"linear_iterations", [](Sample s) { return s.report.linear_iterations; }},
      {"linear_converged", [](Sample s) { return s.report.linear_converged; }},
      {"linear_residual", [](Sample s) { return s.report.linear_residual; }},
      {"line_search_halvings", [](Sample s) { return s.report.line_search_halvings; }},
      {"substeps", [](Sample s) { return s.report.substeps; }},
      {"local_error", [](Sample s) { return s.report.local_error; }},
      {"local_error_met", [](Sample s) { return s.report.local_error_met; }},
      {"kinetic_energy", [](Sample s) { return s.report.kinetic_energy; }}};
  for (Metric& energy : list_energies(energy_types, left_out)) metrics.push_back(std::move(energy));
  const std::vector<Metric> rest{
      {"contact_energy", [](Sample s) { return s.report.contact_energy; }},
      {"energy_rise", [](Sample s) { return s.energy_rise; }},
      {"contacts",
       [](Sample s) {
         return s.report.contacts.strand_contacts + s.report.contacts.collider_contacts;
       }},
      {"strand_contacts", [](Sample s) { return s.report.contacts.strand_contacts; }},
      {"collider_contacts", [](Sample s) { return s.report.contacts.collider_contacts; }},
      {"penetration", [](Sample s) { return s.report.contacts.penetration; }},
      {"crossings", [](Sample s) { return s.report.contacts.crossings; }},
      {"collider_depth", [](Sample s) { return s.report.contacts.depth; }},
      {"mean_rest_distance", [](Sample s) { return s.rest_distance.mean; }},
      {"max_rest_distance", [](Sample s) { return s.rest_distance.max; }},
      {"detect_ms", [](Sample s) { return 1e3 * s.report.seconds.detect; }},
      {"couple_ms", [](Sample s) { return 1e3 * s.report.seconds.couple; }},
      {"evaluate_ms", [](Sample s) { return 1e3 * s.report.seconds.evaluate; }},
      {"solve_ms", [](Sample s) { return 1e3 * s.report.seconds.solve; }},
      {"line_search_ms", [](Sample s) { return 1e3 * s.report.seconds.line_search; }},
      {"step_ms", [](Sample s) { return 1e3 * s.seconds; }}};
  metrics.insert(metrics.end(), rest.begin(), rest.end());
  return metrics;
}

}  // namespace ringlet
