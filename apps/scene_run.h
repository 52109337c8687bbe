#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "apps/metrics_file.h"
#include "apps/run_record.h"
#include "core/observer.h"

namespace ringlet {

/// What a run tells while it goes on.
enum class Telling {
  progress,    ///< to people, on stderr
  nothing,     ///< but warnings and errors
  json_lines,  ///< to programs, on stdout
};

/// Runs a simulation to the end of its scene and writes its run folder.
class SceneRun {
 public:
  /// Writes scene.resolved.json and the heads of the other files; with a checkpoint, brings the
  /// simulation, which has just begun, and all files to it. Throws Error if it cannot.
  SceneRun(const Scene& scene, Simulation& simulation, std::filesystem::path folder,
           const std::optional<std::string>& checkpoint = {});

  /// All steps, unless one fails or the run is interrupted; then everything so far is on disk and
  /// the record says what happened. Throws Error only if not even the summary can be written.
  RunRecord run(const std::string& name, Telling telling);

 private:
  void begin();
  void go_on_from(const std::string& checkpoint);
  void run_steps(Telling telling);
  void record_step(const StepReport& report, double seconds, Telling telling);
  void keep(const StepReport& report, double seconds, std::span<const double> row);
  void finish_observers();
  void write_checkpoint();

  const Scene& scene_;
  Simulation& simulation_;
  std::filesystem::path folder_;
  std::vector<Metric> metrics_;
  std::optional<MetricsFile> metrics_file_;
  EnergyWatch energy_watch_;
  std::vector<std::unique_ptr<Observer>> observers_;
  RunRecord record_;
  std::chrono::steady_clock::time_point last_checkpoint_;
  bool has_checkpoint_ = false;
};

}  // namespace ringlet
