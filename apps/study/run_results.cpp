#include "apps/study/run_results.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "apps/exit_codes.h"
#include "apps/report/metrics_table.h"
#include "core/error.h"
#include "core/json_file.h"
#include "plugins/frames/frames_reader.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

/// A vertex this many times the length of its strand away from where the reference has it, or this
/// many times the kinetic energy: a run that exploded.
constexpr double exploded_lengths = 10, exploded_energies = 1e3;

/// The sum of all columns whose names are chosen, a step.
template <class Chosen>
std::vector<double> sum_of(const MetricsTable& table, const Chosen& is_chosen) {
  std::vector<double> total(table.rows(), 0.0);
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    if (!is_chosen(table.names[c])) continue;
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += table.columns[c][i];
  }
  return total;
}

std::vector<double> column(const MetricsTable& table, const std::string& name) {
  return sum_of(table, [&](const std::string& other) { return other == name; });
}

double mean(const std::vector<double>& values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}
double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, value);
  return most;
}

void read_metrics(const fs::path& run, RunResults& results, std::vector<double>& energy) {
  const MetricsTable metrics = read_metrics_table(run / "metrics.csv");
  results.steps = static_cast<int>(metrics.rows());
  results.newton_iterations = mean(column(metrics, "newton_iterations"));
  results.linear_iterations = mean(column(metrics, "linear_iterations"));
  results.penetration = largest(column(metrics, "penetration"));
  results.largest_kinetic = largest(column(metrics, "kinetic_energy"));
  const auto newton = column(metrics, "newton_converged"),
             linear = column(metrics, "linear_converged");
  for (std::size_t i = 0; i < newton.size(); ++i) {
    if (newton[i] == 0 || linear[i] == 0) ++results.steps_not_converged;
  }
  energy = sum_of(metrics, [](const std::string& name) {
    return name == "kinetic_energy" || (name.starts_with("energy_") && name != "energy_rise");
  });
}

void read_states(const fs::path& run, int every, const std::vector<double>& energy,
                 RunResults& results) {
  FramesReader frames(run / "frames.bin");
  results.vertex_counts = frames.header().vertex_counts;
  for (int i = 1; i < frames.count(); ++i) {
    StoredFrame frame = frames.read(i);
    // A run that failed ends with its last good state, whenever that was.
    if (frame.step % every != 0) break;
    const auto step = static_cast<std::size_t>(frame.step);
    results.states.push_back(
        {frame.time, std::move(frame.positions), step <= energy.size() ? energy[step - 1] : 0.0});
  }
}

void judge(int exit_code, const std::string& message, RunResults& results) {
  results.reason = message;
  if (exit_code == exit_bad_input) {
    results.status = "refused";
  } else if (exit_code == exit_unexpected) {
    results.status = "unexpected";
  } else if (exit_code != exit_ok) {
    results.status = "failed";
  } else if (results.steps_not_converged > 0) {
    results.status = "not_converged";
    results.reason = "in " + std::to_string(results.steps_not_converged) + " of " +
                     std::to_string(results.steps) + " steps an iteration cap was hit";
  } else {
    results.status = "finished";
  }
}

double longest_strand(const RunResults& reference) {
  double most = 0;
  int first = 0;
  const Eigen::Matrix3Xd& x = reference.states.front().positions;
  for (const int count : reference.vertex_counts) {
    double length = 0;
    for (int v = first; v + 1 < first + count; ++v) length += (x.col(v + 1) - x.col(v)).norm();
    most = std::max(most, length);
    first += count;
  }
  return most;
}

void find_explosion(RunResults& results, const RunResults& reference, double largest_distance) {
  if (reference.states.empty()) return;
  const bool is_far = largest_distance > exploded_lengths * longest_strand(reference);
  const bool is_fast = results.largest_kinetic > exploded_energies * reference.largest_kinetic;
  if (!is_far && !is_fast) return;
  const std::string what = is_far ? "a vertex is further than ten strand lengths from where the "
                                    "reference has it"
                                  : "its kinetic energy is a thousand times that of the reference";
  results.reason = what + (results.reason.empty() ? "" : "; " + results.reason);
  results.status = "exploded";
}

/// In one word, what a user of an extreme wants to know of it.
std::string verdict_of(const RunResults& results) {
  if (results.status == "finished" || results.status == "not_converged") return "held";
  const bool is_told = results.status == "refused" || results.status == "failed";
  if (is_told && !results.reason.empty()) return "refused with reason";
  return results.status == "interrupted" ? "not run" : "not held";
}

Json seconds_of(std::vector<double> seconds) {
  if (seconds.empty())
    return {{"seconds", nullptr}, {"seconds_low", nullptr}, {"seconds_high", nullptr}};
  std::sort(seconds.begin(), seconds.end());
  return {{"seconds", seconds[seconds.size() / 2]},
          {"seconds_low", seconds.front()},
          {"seconds_high", seconds.back()}};
}

}  // namespace

RunResults read_results(const Variant& variant, const std::vector<fs::path>& runs) {
  RunResults results;
  if (!variant.refusal.empty()) {
    results.status = "refused";
    results.reason = variant.refusal;
    return results;
  }
  if (runs.empty()) {
    results.status = "interrupted";
    results.reason = "the study was stopped before";
    return results;
  }
  for (const fs::path& run : runs) {
    const Json summary = load_json_if_there(run / "summary.json");
    if (!summary.is_object() || summary.value("status", "") != "finished") continue;
    results.seconds.push_back(1e-3 * summary["milliseconds"]["steps"].get<double>());
    results.peak_memory_bytes =
        std::max(results.peak_memory_bytes, summary["peak_memory_bytes"].get<std::int64_t>());
  }
  std::vector<double> energy;
  read_metrics(runs.front(), results, energy);
  const Json outcome = load_json_if_there(runs.front().string() + ".json");
  judge(outcome.value("exit_code", -1), outcome.value("message", ""), results);
  if (variant.compare_every > 0 && fs::exists(runs.front() / "frames.bin")) {
    read_states(runs.front(), variant.compare_every, energy, results);
  }
  return results;
}

Json describe_variant(const Variant& variant, RunResults results, const RunResults* reference,
                      const std::string& run) {
  MeasuredErrors measured;
  if (reference != nullptr && !results.states.empty()) {
    try {
      measured = measure_errors(results.states, results.vertex_counts, reference->states,
                                reference->vertex_counts);
      find_explosion(results, *reference, measured.largest_distance);
    } catch (const Error& error) {
      results.reason += (results.reason.empty() ? "not compared: " : "; not compared: ") +
                        std::string(error.what());
    }
  }
  for (const std::string& name : error_names()) {
    if (!measured.errors.contains(name)) measured.errors[name] = nullptr;
  }
  if (results.steps > 0) measured.errors["penetration"] = results.penetration;
  Json entry{{"name", variant.name},
             {"values", variant.values},
             {"status", results.status},
             {"reason", results.reason},
             {"verdict", verdict_of(results)},
             {"steps", results.steps},
             {"newton_iterations", results.newton_iterations},
             {"linear_iterations", results.linear_iterations},
             {"steps_not_converged", results.steps_not_converged},
             {"errors", measured.errors},
             {"at", measured.at},
             {"peak_memory_bytes", results.peak_memory_bytes},
             {"run", run}};
  entry.update(seconds_of(results.seconds));
  return entry;
}

}  // namespace ringlet
