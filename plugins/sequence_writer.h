#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

#include "core/observer.h"
#include "core/parameters.h"

namespace ringlet {

/// What every writer of a sequence of files takes.
struct SequenceParameters {
  int every = 1;

  static Schema<SequenceParameters> schema() {
    return Schema<SequenceParameters>().key(
        "every", &SequenceParameters::every, "", at_least(1),
        "steps from one file to the next; the first and the last state are always written");
  }
};

/// Writes each state as a file of its own, frames/frame_<step>.EXTENSION, which appears whole or
/// not at all.
class SequenceWriter final : public Observer {
 public:
  /// Writes one state of strands.
  using Format = std::function<void(const Strands&, const State&, std::ostream&)>;

  SequenceWriter(std::string extension, const SequenceParameters& parameters, Format format)
      : extension_(std::move(extension)), parameters_(parameters), format_(std::move(format)) {}

  void begin(const Model& model, const State& state, const std::filesystem::path& folder) override;
  void resume(const Model& model, const State& state, const std::filesystem::path& folder,
              int step) override;
  void observe(const Model& model, const State& state, int step, const StepReport& report) override;
  void end(const Model& model, const State& state, int step) override;

 private:
  /// Removes all files but those until a step that observe() would have written.
  void keep_files(const std::filesystem::path& folder, int last_step);
  void write(const Model& model, const State& state, int step);

  std::string extension_;
  SequenceParameters parameters_;
  Format format_;
  std::filesystem::path folder_;
  int last_step_ = -1;
};

}  // namespace ringlet
