#pragma once

#include <fstream>

#include "core/observer.h"
#include "plugins/frames/frames_format.h"

namespace ringlet {

struct FramesParameters {
  int every = 1;
  FramePrecision precision = FramePrecision::single;

  static Schema<FramesParameters> schema() {
    return Schema<FramesParameters>()
        .key("every", &FramesParameters::every, "", at_least(1),
             "steps from one frame to the next; the first and the last state are always written")
        .key("precision", &FramesParameters::precision, "", any_number(),
             "of the positions: single is half the size");
  }
};

/// Appends frames to frames.bin, see frames_format.h.
class FramesWriter final : public Observer {
 public:
  explicit FramesWriter(const FramesParameters& parameters) : parameters_(parameters) {}

  void begin(const Model& model, const State& state, const std::filesystem::path& folder) override;
  void resume(const Model& model, const State& state, const std::filesystem::path& folder,
              int step) override;
  void observe(const Model& model, const State& state, int step, const StepReport& report) override;
  void end(const Model& model, const State& state, int step) override;

 private:
  void open(const std::filesystem::path& folder, std::ios::openmode how);
  void append(const State& state, int step);
  void write(const std::string& bytes);

  FramesParameters parameters_;
  std::filesystem::path path_;
  std::ofstream file_;
  int last_step_ = -1;
};

}  // namespace ringlet
