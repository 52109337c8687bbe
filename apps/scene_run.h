#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "apps/metrics_file.h"
#include "apps/run_record.h"
#include "core/observer.h"

namespace ringlet {

/// Runs a simulation to the end of its scene and writes its run folder.
class SceneRun {
 public:
  /// Writes scene.resolved.json and the heads of the other files. Throws Error if it cannot.
  SceneRun(const Scene& scene, Simulation& simulation, std::filesystem::path folder);

  /// All steps, unless one fails or the run is interrupted; then everything so far is on disk and
  /// the record says what happened. Throws Error only if not even the summary can be written.
  RunRecord run(const std::string& name, bool quiet);

 private:
  void run_steps(RunRecord& record, bool quiet);
  void record_step(RunRecord& record, const StepReport& report, double seconds);

  const Scene& scene_;
  Simulation& simulation_;
  std::filesystem::path folder_;
  std::vector<Metric> metrics_;
  MetricsFile metrics_file_;
  EnergyWatch energy_watch_;
  std::vector<std::unique_ptr<Observer>> observers_;
};

}  // namespace ringlet
