#include "tests/apps/study_page/sample_results.h"

namespace ringlet {

Json sample_variant(const std::string& name, double seconds, double error) {
  return {{"name", name},
          {"values", {{"dt", "0.01"}, {"filter", "clamp"}}},
          {"status", "finished"},
          {"reason", ""},
          {"seconds", seconds},
          {"seconds_low", 0.9 * seconds},
          {"seconds_high", 1.2 * seconds},
          {"steps", 60},
          {"newton_iterations", 3.0},
          {"linear_iterations", 12.0},
          {"steps_not_converged", 0},
          {"errors", {{"mean_distance", error}, {"energy", 1e-9}}},
          {"at", Json::array({{{"time", 0.1}, {"mean_distance", error}}})},
          {"peak_memory_bytes", 41000000},
          {"run", "runs/" + name}};
}

Json sample_results() {
  Json coarse = sample_variant("coarse", 0.5, 4e-3), middle = sample_variant("middle", 1.5, 1e-3);
  coarse["values"]["dt"] = "0.03";
  coarse["status"] = middle["status"] = "not_converged";
  coarse["reason"] = middle["reason"] = "in 7 of 60 steps";
  Json wild = sample_variant("wild", 0.7, 1);
  wild["status"] = "exploded";
  wild["reason"] = "a vertex flew away";
  wild["errors"] = {{"mean_distance", nullptr}, {"energy", nullptr}};
  Json odd = wild;
  odd["name"] = "odd";
  odd["status"] = "refused";
  odd["reason"] = "/solver: expected one of 'pcg'";
  odd["seconds"] = odd["seconds_low"] = odd["seconds_high"] = nullptr;
  return {
      {"study", {{"name", "steps"}, {"about", "How long?"}, {"scene", "curl"}}},
      {"duration", 2.0},
      {"repetitions", 3},
      {"machine", {{"processor", "one"}}},
      {"timing_note", ""},
      {"errors",
       {{{"name", "mean_distance"}, {"label", "mean distance"}, {"unit", "m"}},
        {{"name", "energy"}, {"label", "energy"}, {"unit", "J"}}}},
      {"axes",
       {{{"name", "dt"}, {"label", "time step"}, {"unit", "s"}, {"values", {"0.03", "0.01"}}},
        {{"name", "filter"}, {"label", "filter"}, {"unit", ""}, {"values", {"tight", "clamp"}}}}},
      {"default", "fine"},
      {"reference", sample_variant("reference", 100, 0)},
      {"variants", {coarse, middle, sample_variant("fine", 3, 2e-4), wild, odd}},
      {"fronts", {{"mean_distance", {"coarse", "middle", "fine"}}}},
      {"recommendations", {{"mean_distance", {"take middle"}}}}};
}

}  // namespace ringlet
