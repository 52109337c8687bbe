// Writes where the tips of strands are, a row a step.

#include <spdlog/fmt/fmt.h>

#include <fstream>
#include <numeric>

#include "core/keep_lines.h"
#include "core/observer.h"
#include "core/plugin.h"

namespace {

using namespace ringlet;

struct TipTrackParameters {
  std::vector<int> strands;

  static Schema<TipTrackParameters> schema() {
    return Schema<TipTrackParameters>().key("strands", &TipTrackParameters::strands, "",
                                            at_least(0),
                                            "numbers of the strands, from 0; empty: all");
  }
};

/// tips.csv in the run folder: time, then x, y, z of each tip. Each row is complete on disk when
/// its step ends.
class TipTrack final : public Observer {
 public:
  explicit TipTrack(const TipTrackParameters& parameters) : strands_(parameters.strands) {}

  void begin(const Model& model, const State& state, const std::filesystem::path& folder) override {
    choose_strands(model.strands);
    path_ = folder / "tips.csv";
    file_.open(path_, std::ios::binary);
    std::string head = "time";
    for (const int strand : strands_) head += fmt::format(",x_{0},y_{0},z_{0}", strand);
    write_line(head);
    write_row(model.strands, state);
  }

  void resume(const Model& model, const State&, const std::filesystem::path& folder,
              int step) override {
    choose_strands(model.strands);
    path_ = folder / "tips.csv";
    const int head_and_start = 2;
    keep_lines(path_, head_and_start + step);
    file_.open(path_, std::ios::binary | std::ios::app);
  }

  void observe(const Model& model, const State& state, int, const StepReport&) override {
    write_row(model.strands, state);
  }

  /// Nothing was skipped.
  void end(const Model&, const State&, int) override {}

 private:
  void choose_strands(const Strands& strands) {
    if (strands_.empty()) {
      strands_.resize(strands.count());
      std::iota(strands_.begin(), strands_.end(), 0);
    }
    for (const int strand : strands_) {
      if (strand < strands.count()) continue;
      throw Error(fmt::format("there is no strand {}; the scene has those from 0 to {}", strand,
                              strands.count() - 1));
    }
  }

  void write_row(const Strands& strands, const State& state) {
    std::string row = fmt::format("{}", state.time);
    for (const int strand : strands_) {
      const Eigen::Vector3d tip = state.positions.get(strands.first(strand + 1) - 1);
      row += fmt::format(",{},{},{}", tip.x(), tip.y(), tip.z());
    }
    write_line(row);
  }

  void write_line(const std::string& line) {
    file_ << line << '\n' << std::flush;
    if (!file_) throw Error("cannot write '" + path_.string() + "': is the disk full?");
  }

  std::vector<int> strands_;
  std::filesystem::path path_;
  std::ofstream file_;
};

void register_tip_track(Registry& registry) {
  registry.of<Observer>().add<TipTrackParameters>(
      "tip_track", {"positions of the tips of strands: tips.csv, a row a step", "", ""},
      [](const TipTrackParameters& parameters) { return std::make_unique<TipTrack>(parameters); });
}

}  // namespace

RINGLET_PLUGIN(register_tip_track);
