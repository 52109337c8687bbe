#pragma once

#include <string>
#include <vector>

#include "core/observer.h"
#include "core/parameters.h"
#include "plugins/vtp/vtp_format.h"

namespace ringlet {

struct VtpParameters {
  int every = 1;
  VtpEncoding encoding = VtpEncoding::binary;

  static Schema<VtpParameters> schema() {
    return Schema<VtpParameters>()
        .key("every", &VtpParameters::every, "", at_least(1),
             "steps from one frame to the next; the first and the last state are always written")
        .key("encoding", &VtpParameters::encoding, "", any_number(),
             "of the numbers: binary is raw, small and quick; ascii can be read by eye");
  }
};

/// Writes frames/frame_<step>.vtp and rewrites run.pvd, the index of the frames written so far,
/// after each of them. Identical states give identical bytes.
class VtpWriter final : public Observer {
 public:
  explicit VtpWriter(const VtpParameters& parameters) : parameters_(parameters) {}

  void begin(const Model& model, const State& state, const std::filesystem::path& folder) override;
  void resume(const Model& model, const State& state, const std::filesystem::path& folder,
              int step) override;
  void observe(const Model& model, const State& state, int step, const StepReport& report) override;
  void end(const Model& model, const State& state, int step) override;

 private:
  struct Frame {
    int step;
    double time;  ///< s
    std::string file;
  };
  /// Removes all frames but those up to a step that observe() would have written.
  void keep_frames(const std::filesystem::path& folder, int last);
  void write_frame(const Model& model, const State& state, int step);
  void write_index() const;

  VtpParameters parameters_;
  std::filesystem::path folder_;
  std::vector<Frame> frames_;
};

}  // namespace ringlet
