#include "plugins/usda/usda_writer.h"

#include <spdlog/fmt/fmt.h>

#include <iterator>

#include "core/error.h"
#include "plugins/usda/usda_text.h"

namespace ringlet {
namespace {

// Fields that are written again have the width of the longest number, so that nothing behind them
// moves.
constexpr int time_width = 24;
constexpr int extent_width = 120;

std::string point(const Eigen::Vector3f& x) {
  return fmt::format("({}, {}, {})", x[0], x[1], x[2]);
}

std::string vertex_counts(const Strands& strands) {
  std::vector<int> counts;
  for (int strand = 0; strand < strands.count(); ++strand) counts.push_back(strands.size(strand));
  return fmt::format("{}", fmt::join(counts, ", "));
}

/// Diameters, m.
std::string widths(const Strands& strands) {
  std::vector<float> widths;
  for (int v = 0; v < strands.vertex_count(); ++v) {
    widths.push_back(2 * static_cast<float>(strands.radius(v)));
  }
  return fmt::format("{}", fmt::join(widths, ", "));
}

}  // namespace

void UsdaWriter::begin(const Model& model, const State& state,
                       const std::filesystem::path& folder) {
  path_ = folder / "run.usda";
  file_.open(path_, std::ios::binary | std::ios::in | std::ios::out | std::ios::trunc);
  extent_.setEmpty();
  file_ << head(model.strands, time_code(state));
  append(state, 0);
}

void UsdaWriter::resume(const Model& model, const State& state, const std::filesystem::path& folder,
                        int step) {
  path_ = folder / "run.usda";
  file_.open(path_, std::ios::binary | std::ios::in | std::ios::out);
  std::string expected = head(model.strands, 0), found(expected.size(), '\0');
  file_.read(found.data(), static_cast<std::streamsize>(found.size()));
  for (std::string* text : {&expected, &found}) {
    text->replace(static_cast<std::size_t>(end_time_), time_width, time_width, ' ');
  }
  if (!file_ || found != expected) {
    throw Error("'" + path_.string() + "' is not there, or of other strands or parameters");
  }
  const bool with_last = step % parameters_.sequence.every == 0;
  keep_samples(time_code(state), with_last);
  last_step_ = with_last ? step : -1;
}

void UsdaWriter::keep_samples(double last_code, bool with_last) {
  extent_.setEmpty();
  double end_code = 0;
  for (std::string line; std::getline(file_, line) && !file_.eof() && line.ends_with("],");) {
    UsdaText text(path_, line);
    const double sample_code = text.take_number();
    if (sample_code > last_code || (sample_code == last_code && !with_last)) break;
    text.expect(':');
    for (const Eigen::Vector3d& x : text.take_points()) extent_.extend(x.cast<float>());
    tail_ += static_cast<std::streamoff>(line.size() + 1);
    end_code = sample_code;
  }
  if (extent_.isEmpty()) throw Error("'" + path_.string() + "' holds no whole state");
  std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(tail_));
  file_.clear();
  file_.seekp(tail_);
  file_ << tail();
  write_end_time(end_code);
}

void UsdaWriter::observe(const Model&, const State& state, int step, const StepReport&) {
  if (step % parameters_.sequence.every == 0) append(state, step);
}

void UsdaWriter::end(const Model&, const State& state, int step) {
  if (last_step_ != step) append(state, step);
}

std::string UsdaWriter::head(const Strands& strands, double start) {
  const std::string begin =
      "#usda 1.0\n(\n    defaultPrim = \"strands\"\n    doc = \"strands of ringlet\"\n"
      "    endTimeCode = ";
  const std::string rest = fmt::format(
      "{:<{}}\n    metersPerUnit = 1\n    startTimeCode = {}\n    timeCodesPerSecond = {}\n"
      "    upAxis = \"Y\"\n)\n\ndef BasisCurves \"strands\"\n{{\n"
      "    uniform token type = \"linear\"\n    uniform token wrap = \"nonperiodic\"\n"
      "    int[] curveVertexCounts = [{}]\n"
      "    float[] widths = [{}] (\n        interpolation = \"vertex\"\n    )\n"
      "    point3f[] points.timeSamples = {{\n",
      0, time_width, start, parameters_.time_codes_per_second, vertex_counts(strands),
      widths(strands));
  end_time_ = static_cast<std::streamoff>(begin.size());
  tail_ = static_cast<std::streamoff>(begin.size() + rest.size());
  return begin + rest;
}

void UsdaWriter::append(const State& state, int step) {
  const std::string line = sample(state);
  file_.seekp(tail_);
  file_ << line << tail() << std::flush;
  tail_ += static_cast<std::streamoff>(line.size());
  write_end_time(time_code(state));
  if (!file_) throw Error("cannot write '" + path_.string() + "': is the disk full?");
  last_step_ = step;
}

std::string UsdaWriter::sample(const State& state) {
  fmt::memory_buffer line;
  fmt::format_to(std::back_inserter(line), "        {}: [", time_code(state));
  for (int v = 0; v < state.positions.groups().vertex_count(); ++v) {
    const Eigen::Vector3f x = state.positions.get(v).cast<float>();
    extent_.extend(x);
    fmt::format_to(std::back_inserter(line), "{}({}, {}, {})", v == 0 ? "" : ", ", x[0], x[1],
                   x[2]);
  }
  return fmt::to_string(line) + "],\n";
}

std::string UsdaWriter::tail() const {
  return fmt::format("    }}\n    float3[] extent = {:<{}}\n}}\n",
                     fmt::format("[{}, {}]", point(extent_.min()), point(extent_.max())),
                     extent_width);
}

void UsdaWriter::write_end_time(double code) {
  file_.seekp(end_time_);
  file_ << fmt::format("{:<{}}", code, time_width) << std::flush;
}

}  // namespace ringlet
