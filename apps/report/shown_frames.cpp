#include "apps/report/shown_frames.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "plugins/vtp/vtp_reader.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

struct FrameFile {
  int step;
  fs::path path;
};

/// The step of frames/frame_00012.vtp.
std::optional<int> step_of(const fs::path& path) {
  const std::string stem = path.stem().string(), start = "frame_";
  if (path.extension() != ".vtp" || !stem.starts_with(start)) return {};
  const std::string digits = stem.substr(start.size());
  if (digits.empty() || digits.size() > 9 ||
      !std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    return {};
  }
  return std::stoi(digits);
}

std::vector<FrameFile> list_files(const fs::path& folder) {
  std::vector<FrameFile> files;
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (const auto step = step_of(entry.path())) files.push_back({*step, entry.path()});
    }
  }
  std::sort(files.begin(), files.end(),
            [](const FrameFile& a, const FrameFile& b) { return a.step < b.step; });
  return files;
}

std::optional<VtpFrame> read_or_note(const FrameFile& file, std::vector<std::string>& notes) {
  try {
    return read_vtp_frame(file.path);
  } catch (const Error& error) {
    notes.push_back(fmt::format("Left out: {}.", error.what()));
    return {};
  }
}

/// Vertices of the strands that are shown.
std::vector<int> shown_vertices(const VtpFrame& frame, int every_strand, ShownFrames& shown) {
  std::vector<int> vertices;
  for (const int strand : kept(shown.strands, every_strand, false)) {
    shown.first.push_back(static_cast<int>(vertices.size()));
    const int begin = strand == 0 ? 0 : frame.offsets[strand - 1];
    for (int v = begin; v < frame.offsets[strand]; ++v) vertices.push_back(v);
  }
  shown.first.push_back(static_cast<int>(vertices.size()));
  return vertices;
}

/// Without what tells contacts when it fails.
void append_contacts(const VtpFrame& frame, const std::vector<int>& vertices, ShownFrames& shown,
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

void append(const VtpFrame& frame, int step, const std::vector<int>& vertices, ShownFrames& shown) {
  std::vector<float>& positions = shown.positions.emplace_back();
  positions.reserve(3 * vertices.size());
  for (const int v : vertices) {
    positions.insert(positions.end(), &frame.points[3 * v], &frame.points[3 * v] + 3);
  }
  shown.steps.push_back(step);
  shown.times.push_back(frame.time);
}

}  // namespace

ShownFrames read_shown_frames(const fs::path& folder, std::int64_t budget_bytes,
                              std::unique_ptr<ContactForces> contacts,
                              std::vector<std::string>& notes) {
  std::vector<FrameFile> files = list_files(folder / "frames");
  std::optional<VtpFrame> last;
  while (!files.empty() && !(last = read_or_note(files.back(), notes))) files.pop_back();
  if (files.empty()) {
    throw Error("'" + folder.string() +
                "' has no frame to show; expected frames/frame_<step>.vtp, which a scene writes "
                "with \"run\": {\"write\": [\"vtp\"]}" +
                (notes.empty() ? "" : ". " + notes.front()));
  }

  ShownFrames shown;
  shown.count = static_cast<int>(files.size());
  shown.strands = static_cast<int>(last->offsets.size());
  shown.vertices = last->offsets.back();
  shown.thinning = thin(shown.count, shown.vertices, shown.strands, budget_bytes);
  const std::vector<int> vertices = shown_vertices(*last, shown.thinning.every_strand, shown);
  for (const int v : vertices) shown.radii.push_back(last->radii[v]);
  for (const int number : kept(shown.count, shown.thinning.every_frame, true)) {
    const FrameFile& file = files[number];
    const auto frame = number == shown.count - 1 ? last : read_or_note(file, notes);
    if (!frame) continue;
    if (frame->offsets != last->offsets) {
      notes.push_back("Left out: '" + file.path.string() + "' is of other strands.");
    } else {
      append(*frame, file.step, vertices, shown);
      append_contacts(*frame, vertices, shown, contacts, notes);
    }
  }
  return shown;
}

}  // namespace ringlet
