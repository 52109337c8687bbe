#include "apps/run_record.h"

#include <algorithm>
#include <cstdint>

#include "apps/machine.h"

namespace ringlet {
namespace {

std::string status(const RunRecord& record) {
  if (!record.failure.empty()) return "failed";
  return record.interrupted ? "interrupted" : "finished";
}

Json milliseconds(const RunRecord& record) {
  const StageSeconds& seconds = record.seconds;
  return {{"detect", 1e3 * seconds.detect},           {"couple", 1e3 * seconds.couple},
          {"evaluate", 1e3 * seconds.evaluate},       {"solve", 1e3 * seconds.solve},
          {"line_search", 1e3 * seconds.line_search}, {"steps", 1e3 * record.step_seconds}};
}

Json size_of(const Model& model) {
  const int vertices = model.strands.vertex_count();
  return {{"strands", model.strands.count()},
          {"vertices", vertices},
          {"pinned_vertices", model.pins.size()},
          {"degrees_of_freedom", 3 * (static_cast<std::int64_t>(vertices) -
                                      static_cast<std::int64_t>(model.pins.size()))}};
}

Json list_results(const std::vector<ExpectationResult>& results) {
  Json list = Json::array();
  for (const ExpectationResult& result : results) {
    Json entry = Expectation::schema().write(result.expectation);
    entry["value"] = result.value ? Json(*result.value) : Json();
    entry["met"] = result.value ? Json(result.met()) : Json();
    list.push_back(std::move(entry));
  }
  return list;
}

/// What the scene pays for.
Json list_modules(const std::vector<ModuleCost>& modules) {
  Json list = Json::array();
  for (const ModuleCost& module : modules) {
    Json entry{{"kind", module.kind}};
    if (!module.name.empty()) entry["name"] = module.name;
    if (module.left_out) {
      entry["left_out"] = "it is zero wherever the strands are";
    } else {
      entry["seconds"] = module.seconds;
      entry["bytes"] = module.bytes;
    }
    list.push_back(std::move(entry));
  }
  return list;
}

Json describe_rest(const RestReport& rest) {
  return {{"strands", rest.strands},
          {"not_held", rest.not_held},
          {"acceleration", rest.acceleration},
          {"unstable", rest.unstable},
          {"elements_without_rest", rest.without_rest}};
}

}  // namespace

void RunRecord::add(const StepReport& report, double duration) {
  ++steps;
  step_seconds += duration;
  seconds += report.seconds;
  newton_caps += report.newton_converged ? 0 : 1;
  linear_caps += report.linear_converged ? 0 : 1;
  error_caps += report.local_error_met ? 0 : 1;
}

bool RunRecord::met_expectations() const {
  return std::all_of(expectations.begin(), expectations.end(),
                     [](const ExpectationResult& result) { return !result.value || result.met(); });
}

Json summarise(const RunRecord& record, const Simulation& simulation) {
  Json summary{{"scene", record.scene},
               {"status", status(record)},
               {"failure", record.failure},
               {"steps", record.steps},
               {"steps_wanted", record.steps_wanted},
               {"simulated_seconds", simulation.state().time},
               {"wall_seconds", record.wall_seconds},
               {"steps_per_second", record.steps > 0 ? record.steps / record.wall_seconds : 0.0},
               {"milliseconds", milliseconds(record)},
               {"steps_newton_not_converged", record.newton_caps},
               {"steps_linear_not_converged", record.linear_caps},
               {"steps_local_error_not_met", record.error_caps}};
  summary.update(size_of(simulation.model()));
  const auto& rest = simulation.model().rest;
  if (rest) summary["rest"] = describe_rest(*rest);
  const std::string account = simulation.model().solver->account();
  if (!account.empty()) summary["solver"] = account;
  summary["modules"] = list_modules(record.modules);
  summary["peak_memory_bytes"] = peak_memory_bytes();
  summary.update(describe_machine());
  summary["expect"] = list_results(record.expectations);
  return summary;
}

}  // namespace ringlet
