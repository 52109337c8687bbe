#include "apps/convert/input_frames.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <limits>

#include "core/strand_reader.h"
#include "plugins/usda/usda_reader.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

InputFrames frames_of_run(const fs::path& path) {
  const auto run = std::make_shared<RunFrames>(path);
  for (const std::string& reason : run->left_out()) spdlog::warn("left out: {}", reason);
  return {run->vertex_counts(), run->radii(), run->steps(),
          [run](int number) { return run->read(number); }};
}

InputFrames frames_of_usda(const fs::path& path, const InputUnits& units) {
  const auto reader = std::make_shared<UsdaReader>(path);
  InputFrames frames{reader->vertex_counts(), reader->radii(), {}, {}};
  int vertices = 0;
  for (const int count : frames.vertex_counts) vertices += count;
  if (frames.radii.empty()) frames.radii.assign(static_cast<std::size_t>(vertices), units.radius);
  for (std::size_t i = 0; i < reader->times().size(); ++i) {
    frames.steps.push_back(static_cast<int>(i));
  }
  frames.read = [reader](int number) {
    return RunFrame{number, reader->times()[static_cast<std::size_t>(number)],
                    reader->read(number)};
  };
  return frames;
}

/// Strands of fewer than two vertices, which few formats can hold, are left out.
void drop_single_vertices(const std::string& name, Polylines& polylines) {
  Polylines kept;
  std::size_t first = 0;
  for (const int count : polylines.vertex_counts) {
    const std::size_t end = first + static_cast<std::size_t>(count);
    for (std::size_t v = first; count > 1 && v < end; ++v) {
      kept.positions.push_back(polylines.positions[v]);
      if (!polylines.radii.empty()) kept.radii.push_back(polylines.radii[v]);
    }
    if (count > 1) kept.vertex_counts.push_back(count);
    first = end;
  }
  const std::size_t strands = polylines.vertex_counts.size();
  if (const std::size_t dropped = strands - kept.vertex_counts.size(); dropped > 0) {
    spdlog::warn("'{}': {} of {} strands left out that have fewer than two vertices", name, dropped,
                 strands);
  }
  polylines = std::move(kept);
}

InputFrames frame_of_file(const fs::path& path, const InputUnits& units, const Registry& registry) {
  std::vector<Problem> problems;
  ParseContext context{registry, fs::current_path(), {}, problems};
  Choice<StrandReader> choice;
  Codec<Choice<StrandReader>>::read(extension_of(path), "", {}, context, choice);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  Polylines polylines = choice.make()->read(path);
  drop_single_vertices(path.string(), polylines);
  const std::size_t count = polylines.positions.size();
  if (count == 0 || count > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw Error("'" + path.string() + "' has " + std::to_string(count) +
                " vertices of strands; expected 2 to 2^31 - 1");
  }
  if (polylines.radii.empty()) polylines.radii.assign(count, units.radius / units.scale);
  for (double& radius : polylines.radii) radius *= units.scale;
  const Eigen::Map<const Eigen::Matrix3Xd> positions(polylines.positions[0].data(), 3,
                                                     static_cast<Eigen::Index>(count));
  const RunFrame frame{0, 0, units.scale * positions};
  return {polylines.vertex_counts, polylines.radii, {0}, [frame](int) { return frame; }};
}

InputFrames open_in_metres(const fs::path& path, const InputUnits& units) {
  if (units.scale != 1) {
    throw Error("'" + path.string() + "' is in metres: --scale cannot be given");
  }
  return extension_of(path) == "usda" ? frames_of_usda(path, units) : frames_of_run(path);
}

}  // namespace

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

InputFrames open_input(const fs::path& path, const InputUnits& units, const Registry& registry) {
  if (!fs::exists(path)) throw Error("there is no '" + path.string() + "'");
  const std::string extension = extension_of(path);
  if (fs::is_directory(path) || extension == "bin" || extension == "pvd" || extension == "usda") {
    return open_in_metres(path, units);
  }
  const auto& readers = registry.of<StrandReader>();
  if (readers.find(extension) == nullptr) {
    std::vector<std::string> known = readers.names();
    known.insert(known.end(), {"bin", "pvd"});
    throw Error("'" + path.string() + "': files named '." + extension + "' cannot be read; " +
                did_you_mean(extension, known));
  }
  return frame_of_file(path, units, registry);
}

InputFrames only_frame(const InputFrames& frames, int step) {
  const auto found = std::find(frames.steps.begin(), frames.steps.end(), step);
  if (found == frames.steps.end()) {
    throw Error("there is no frame of step " + std::to_string(step) + "; there are " +
                std::to_string(frames.steps.size()) + ", of the steps " +
                std::to_string(frames.steps.front()) + " to " +
                std::to_string(frames.steps.back()));
  }
  const int number = static_cast<int>(found - frames.steps.begin());
  return {frames.vertex_counts, frames.radii, {step}, [read = frames.read, number](int) {
            return read(number);
          }};
}

}  // namespace ringlet
