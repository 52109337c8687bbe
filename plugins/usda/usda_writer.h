#pragma once

#include <Eigen/Geometry>
#include <fstream>

#include "core/observer.h"
#include "plugins/sequence_writer.h"

namespace ringlet {

struct UsdaParameters {
  SequenceParameters sequence;
  double time_codes_per_second = 30;

  static Schema<UsdaParameters> schema() {
    return Schema<UsdaParameters>()
        .include(&UsdaParameters::sequence)
        .key("time_codes_per_second", &UsdaParameters::time_codes_per_second, "1/s", positive(),
             "frames a second of the programs that play it; states may lie between frames");
  }
};

/// Writes run.usda: BasisCurves whose points have a time sample a state, and widths. Coordinates
/// are 32-bit floats. Each state is appended, before a short end that it moves on, so that the file
/// is whole after each of them and no state need be kept in memory.
class UsdaWriter final : public Observer {
 public:
  explicit UsdaWriter(const UsdaParameters& parameters) : parameters_(parameters) {}

  void begin(const Model& model, const State& state, const std::filesystem::path& folder) override;
  void resume(const Model& model, const State& state, const std::filesystem::path& folder,
              int step) override;
  void observe(const Model& model, const State& state, int step, const StepReport& report) override;
  void end(const Model& model, const State& state, int step) override;

 private:
  /// What is ahead of the samples; sets the places in it.
  std::string head(const Strands& strands, double start);
  /// Takes over the samples of an earlier run until a time code, that one only if it is wanted.
  void keep_samples(double last_code, bool with_last);
  void append(const State& state, int step);
  std::string sample(const State& state);
  /// What closes the file, always of the same size.
  std::string tail() const;
  void write_end_time(double code);
  double time_code(const State& state) const {
    return state.time * parameters_.time_codes_per_second;
  }

  UsdaParameters parameters_;
  std::filesystem::path path_;
  std::fstream file_;
  std::streamoff end_time_ = 0;  ///< where it stands in the file
  std::streamoff tail_ = 0;      ///< where the end begins that the next state overwrites
  Eigen::AlignedBox3f extent_;   ///< of all states so far, m
  int last_step_ = -1;
};

}  // namespace ringlet
