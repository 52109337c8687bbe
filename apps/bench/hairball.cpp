#include "apps/bench/hairball.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <cmath>

#include "apps/bench/bench.h"

namespace ringlet {
namespace {

StepReport take_step(Simulation& simulation) {
  StepReport report = simulation.step();
  if (!report.failure.empty()) throw Error(report.failure);
  return report;
}

}  // namespace

Json hairball(int wisps) {
  Json scene = bundled_scene("hairball_2000");
  const double scale = std::sqrt(2000.0 / wisps);
  scene["strands"]["count"] = wisps;
  for (const char* key : {"radius", "tip_radius"}) {
    scene["material"][key] = scale * scene["material"][key].get<double>();
  }
  scene["collision"]["push_at_rest"] = true;
  if (wisps >= 8000) scene["collision"]["thickness"] = 5e-4;
  scene["run"]["write"] = Json::array();
  return scene;
}

Json hairball_without_contacts(int wisps) {
  Json scene = hairball(wisps);
  scene["collision"] = nullptr;
  scene["solver"] = "strand_cholesky";
  scene["integrator"]["newton_tolerance"] = 0;
  return scene;
}

void with_threads(int threads, const std::function<void()>& function) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena(threads).execute(function);
}

Json as_json(const StageSeconds& stages) {
  return {{"detect", stages.detect},
          {"couple", stages.couple},
          {"evaluate", stages.evaluate},
          {"solve", stages.solve},
          {"line_search", stages.line_search}};
}

void skip_steps(Simulation& simulation, int count) {
  for (int step = 0; step < count; ++step) take_step(simulation);
}

StepFigures measure_steps(Simulation& simulation, int count) {
  using Clock = std::chrono::steady_clock;
  std::vector<StepReport> reports;
  std::vector<double> seconds;
  for (int step = 0; step < count; ++step) {
    const Clock::time_point start = Clock::now();
    StepReport report = take_step(simulation);
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    reports.push_back(std::move(report));
  }
  const auto median_of = [&](const auto& value) {
    std::vector<double> values;
    for (const StepReport& report : reports) values.push_back(value(report));
    return median(std::move(values));
  };
  StepFigures figures;
  figures.step = summarise(std::move(seconds));
  figures.stages.detect = median_of([](const StepReport& r) { return r.seconds.detect; });
  figures.stages.couple = median_of([](const StepReport& r) { return r.seconds.couple; });
  figures.stages.evaluate = median_of([](const StepReport& r) { return r.seconds.evaluate; });
  figures.stages.solve = median_of([](const StepReport& r) { return r.seconds.solve; });
  figures.stages.line_search = median_of([](const StepReport& r) { return r.seconds.line_search; });
  figures.newton_iterations = median_of([](const StepReport& r) { return r.newton_iterations; });
  figures.linear_iterations = median_of([](const StepReport& r) { return r.linear_iterations; });
  figures.contacts = median_of([](const StepReport& r) {
    return r.contacts.strand_contacts + r.contacts.collider_contacts;
  });
  return figures;
}

}  // namespace ringlet
