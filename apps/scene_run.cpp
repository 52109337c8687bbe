#include "apps/scene_run.h"

#include "apps/checkpoint_file.h"
#include "apps/interrupt.h"
#include "apps/json_lines.h"
#include "apps/progress.h"
#include "apps/run_replay.h"

namespace ringlet {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

SceneRun::SceneRun(const Scene& scene, Simulation& simulation, std::filesystem::path folder,
                   const std::optional<std::string>& checkpoint)
    : scene_(scene),
      simulation_(simulation),
      folder_(std::move(folder)),
      metrics_(list_metrics(energy_names(simulation.model()),
                            left_out_energy_names(simulation.model()))),
      energy_watch_(simulation.model(), simulation.state()),
      last_checkpoint_(Clock::now()) {
  for (const auto& writer : scene.run.write) observers_.push_back(writer.make());
  if (checkpoint) {
    go_on_from(*checkpoint);
  } else {
    begin();
  }
}

void SceneRun::begin() {
  write_json(folder_ / "scene.resolved.json", scene_.resolved());
  std::filesystem::remove(folder_ / "summary.json");
  metrics_file_.emplace(folder_ / "metrics.csv", metrics_);
  for (const auto& observer : observers_) {
    naming(*observer, [&] { observer->begin(simulation_.model(), simulation_.state(), folder_); });
  }
}

void SceneRun::go_on_from(const std::string& checkpoint) {
  simulation_.go_on_from(checkpoint);
  const int step = simulation_.steps_done();
  if (step > scene_.run.steps) {
    throw Error("the run is at step " + std::to_string(step) + " already; expected at most " +
                std::to_string(scene_.run.steps));
  }
  for (const auto& row : read_rows(read_metrics_table(folder_ / "metrics.csv"), metrics_, step)) {
    const RecordedStep recorded = recorded_step(metrics_, row);
    energy_watch_.rise_after(recorded.report);
    keep(recorded.report, recorded.seconds, row);
  }
  record_.wall_seconds = record_.step_seconds;
  for (const auto& observer : observers_) {
    naming(*observer,
           [&] { observer->resume(simulation_.model(), simulation_.state(), folder_, step); });
  }
  metrics_file_.emplace(folder_ / "metrics.csv", step);
  std::filesystem::remove(folder_ / "summary.json");
  write_json(folder_ / "scene.resolved.json", scene_.resolved());
  has_checkpoint_ = true;
}

RunRecord SceneRun::run(const std::string& name, Telling telling) {
  record_.scene = name;
  record_.steps_wanted = scene_.run.steps;
  const Clock::time_point start = Clock::now();
  try {
    run_steps(telling);
    if (has_checkpoint_ && record_.failure.empty()) write_checkpoint();
    finish_observers();
  } catch (const Error& error) {
    record_.failure = error.what();
  }
  record_.wall_seconds += seconds_since(start);
  for (const Expectation& expectation : scene_.expect) {
    if (expectation.step > record_.steps) record_.expectations.push_back({expectation, {}});
  }
  record_.modules = list_costs(simulation_);
  for (const auto& observer : observers_) record_.modules.push_back(cost_of(*observer));
  const Json summary = summarise(record_, simulation_);
  write_json(folder_ / "summary.json", summary);
  if (telling == Telling::json_lines) print_summary_line(summary, folder_);
  return record_;
}

void SceneRun::run_steps(Telling telling) {
  const Interrupt interrupt;
  Progress progress(record_.steps, record_.steps_wanted, telling != Telling::progress);
  while (record_.steps < record_.steps_wanted) {
    if (interrupt.requested()) {
      record_.interrupted = true;
      has_checkpoint_ |= scene_.run.checkpoint_seconds > 0;
      return;
    }
    const Clock::time_point start = Clock::now();
    const StepReport report = simulation_.step();
    if (!report.failure.empty()) {
      record_.failure = "step " + std::to_string(record_.steps + 1) + ": " + report.failure;
      return;
    }
    record_step(report, seconds_since(start), telling);
    progress.show(record_.steps, report);
  }
}

void SceneRun::record_step(const StepReport& report, double seconds, Telling telling) {
  const Model& model = simulation_.model();
  const State& state = simulation_.state();
  const StepSample sample{simulation_.steps_done(),
                          state.time,
                          seconds,
                          report,
                          measure_rest_distance(model, state.positions),
                          energy_watch_.rise_after(report)};
  std::vector<double> row;
  for (const Metric& metric : metrics_) row.push_back(metric.value(sample));
  metrics_file_->append(row);
  keep(report, seconds, row);
  for (const auto& observer : observers_) {
    naming(*observer, [&] { observer->observe(model, state, record_.steps, report); });
  }
  if (telling == Telling::json_lines) print_step_line(metrics_, row);
  const double interval = scene_.run.checkpoint_seconds;
  if (interval > 0 && seconds_since(last_checkpoint_) >= interval) write_checkpoint();
}

void SceneRun::keep(const StepReport& report, double seconds, std::span<const double> row) {
  record_.add(report, seconds);
  for (ExpectationResult& result : check_step(scene_.expect, record_.steps, metrics_, row)) {
    record_.expectations.push_back(std::move(result));
  }
}

void SceneRun::finish_observers() {
  for (const auto& observer : observers_) {
    naming(*observer,
           [&] { observer->end(simulation_.model(), simulation_.state(), record_.steps); });
  }
}

// All that belongs to the step is on disk before: who goes on cuts off only what comes later.
void SceneRun::write_checkpoint() {
  write_checkpoint_file(folder_, simulation_.checkpoint());
  last_checkpoint_ = Clock::now();
  has_checkpoint_ = true;
}

}  // namespace ringlet
