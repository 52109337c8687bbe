#include "apps/scene_run.h"

#include <chrono>

#include "apps/interrupt.h"
#include "apps/progress.h"
#include "core/atomic_file.h"

namespace ringlet {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void write_json(const std::filesystem::path& path, const Json& json) {
  AtomicFile file(path);
  file.stream() << json.dump(2) << '\n';
  file.commit();
}

}  // namespace

SceneRun::SceneRun(const Scene& scene, Simulation& simulation, std::filesystem::path folder)
    : scene_(scene),
      simulation_(simulation),
      folder_(std::move(folder)),
      metrics_(list_metrics(energy_names(simulation.model()),
                            left_out_energy_names(simulation.model()))),
      metrics_file_(folder_ / "metrics.csv", metrics_),
      energy_watch_(simulation.model(), simulation.state()) {
  write_json(folder_ / "scene.resolved.json", scene.resolved());
  for (const auto& writer : scene.run.write) {
    observers_.push_back(writer.make());
    Observer& observer = *observers_.back();
    naming(observer, [&] { observer.begin(simulation.model(), simulation.state(), folder_); });
  }
}

RunRecord SceneRun::run(const std::string& name, bool quiet) {
  RunRecord record;
  record.scene = name;
  record.steps_wanted = scene_.run.steps;
  const Clock::time_point start = Clock::now();
  try {
    run_steps(record, quiet);
    for (const auto& observer : observers_) {
      naming(*observer,
             [&] { observer->end(simulation_.model(), simulation_.state(), record.steps); });
    }
  } catch (const Error& error) {
    record.failure = error.what();
  }
  record.wall_seconds = seconds_since(start);
  for (const Expectation& expectation : scene_.expect) {
    if (expectation.step > record.steps) record.expectations.push_back({expectation, {}});
  }
  record.modules = list_costs(simulation_);
  for (const auto& observer : observers_) record.modules.push_back(cost_of(*observer));
  write_json(folder_ / "summary.json", summarise(record, simulation_));
  return record;
}

void SceneRun::run_steps(RunRecord& record, bool quiet) {
  const Interrupt interrupt;
  Progress progress(record.steps_wanted, quiet);
  while (record.steps < record.steps_wanted) {
    if (interrupt.requested()) {
      record.interrupted = true;
      return;
    }
    const Clock::time_point start = Clock::now();
    const StepReport report = simulation_.step();
    if (!report.failure.empty()) {
      record.failure = "step " + std::to_string(record.steps + 1) + ": " + report.failure;
      return;
    }
    record_step(record, report, seconds_since(start));
    progress.show(record.steps, report);
  }
}

void SceneRun::record_step(RunRecord& record, const StepReport& report, double seconds) {
  record.add(report, seconds);
  const Model& model = simulation_.model();
  const State& state = simulation_.state();
  const StepSample sample{record.steps,
                          state.time,
                          seconds,
                          report,
                          measure_rest_distance(model, state.positions),
                          energy_watch_.rise_after(report)};
  std::vector<double> row;
  for (const Metric& metric : metrics_) row.push_back(metric.value(sample));
  metrics_file_.append(row);
  for (ExpectationResult& result : check_step(scene_.expect, record.steps, metrics_, row)) {
    record.expectations.push_back(std::move(result));
  }
  for (const auto& observer : observers_) {
    naming(*observer, [&] { observer->observe(model, state, record.steps, report); });
  }
}

}  // namespace ringlet
