#include "apps/report/shown_frames.h"

#include <spdlog/fmt/fmt.h>

#include <optional>

#include "core/error.h"
#include "plugins/run_frames.h"

namespace ringlet {
namespace {

std::optional<RunFrame> read_or_note(RunFrames& frames, int number,
                                     std::vector<std::string>& notes) {
  try {
    return frames.read(number);
  } catch (const Error& error) {
    notes.push_back(fmt::format("Left out: {}.", error.what()));
    return {};
  }
}

/// Vertices of the strands that are shown.
std::vector<int> shown_vertices(const RunFrames& frames, ShownFrames& shown) {
  std::vector<int> begins{0};
  for (const int count : frames.vertex_counts()) begins.push_back(begins.back() + count);
  std::vector<int> vertices;
  for (const int strand : kept(shown.strands, shown.thinning.every_strand, false)) {
    shown.first.push_back(static_cast<int>(vertices.size()));
    for (int v = begins[strand]; v < begins[strand + 1]; ++v) vertices.push_back(v);
  }
  shown.first.push_back(static_cast<int>(vertices.size()));
  return vertices;
}

/// Without what tells contacts when it fails.
void append_contacts(const RunFrame& frame, const std::vector<int>& vertices, ShownFrames& shown,
                     std::unique_ptr<ContactForces>& contacts, std::vector<std::string>& notes) {
  if (contacts == nullptr) return;
  try {
    const std::vector<float> forces = contacts->at(frame);
    std::vector<float>& kept_forces = shown.contacts.emplace_back();
    for (const int v : vertices) kept_forces.push_back(forces[v]);
  } catch (const Error& error) {
    notes.push_back(fmt::format("There is no colour for contacts: {}.", error.what()));
    contacts.reset();
    shown.contacts.clear();
  }
}

void append(const RunFrame& frame, const std::vector<int>& vertices, ShownFrames& shown) {
  std::vector<float>& positions = shown.positions.emplace_back();
  positions.reserve(3 * vertices.size());
  for (const int v : vertices) {
    for (const double coordinate : frame.positions.col(v)) {
      positions.push_back(static_cast<float>(coordinate));
    }
  }
  shown.steps.push_back(frame.step);
  shown.times.push_back(frame.time);
}

}  // namespace

ShownFrames read_shown_frames(const std::filesystem::path& folder, std::int64_t budget_bytes,
                              std::unique_ptr<ContactForces> contacts,
                              std::vector<std::string>& notes) {
  RunFrames frames(folder);
  for (const std::string& reason : frames.left_out()) {
    notes.push_back(fmt::format("Left out: {}.", reason));
  }
  if (contacts != nullptr && !contacts->is_of(frames.vertex_counts())) {
    notes.push_back(
        "There is no colour for contacts: the frames do not hold the strands of the scene.");
    contacts.reset();
  }
  ShownFrames shown;
  shown.count = static_cast<int>(frames.steps().size());
  shown.strands = static_cast<int>(frames.vertex_counts().size());
  shown.vertices = static_cast<int>(frames.radii().size());
  shown.thinning = thin(shown.count, shown.vertices, shown.strands, budget_bytes);
  const std::vector<int> vertices = shown_vertices(frames, shown);
  for (const int v : vertices) shown.radii.push_back(static_cast<float>(frames.radii()[v]));
  for (const int number : kept(shown.count, shown.thinning.every_frame, true)) {
    const auto frame = read_or_note(frames, number, notes);
    if (!frame) continue;
    append(*frame, vertices, shown);
    append_contacts(*frame, vertices, shown, contacts, notes);
  }
  return shown;
}

}  // namespace ringlet
