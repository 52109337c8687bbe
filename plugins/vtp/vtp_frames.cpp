#include "plugins/vtp/vtp_frames.h"

#include <algorithm>
#include <optional>
#include <string>

#include "plugins/vtp/pvd.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

/// The step of frames/frame_00012.vtp, or of another name that ends so.
std::optional<int> step_of(const fs::path& path) {
  const std::string stem = path.stem().string();
  const std::string digits = stem.substr(stem.rfind('_') + 1);
  if (digits.empty() || digits.size() > 9 ||
      !std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    return {};
  }
  return std::stoi(digits);
}

bool is_frame(const fs::path& path) {
  const std::string stem = path.stem().string();
  return path.extension() == ".vtp" && stem.rfind('_') == 5 && stem.starts_with("frame_");
}

}  // namespace

std::vector<VtpFrameFile> list_vtp_frames(const fs::path& folder) {
  std::vector<VtpFrameFile> files;
  if (!fs::is_directory(folder / "frames")) return files;
  for (const auto& entry : fs::directory_iterator(folder / "frames")) {
    const auto step = is_frame(entry.path()) ? step_of(entry.path()) : std::nullopt;
    if (step) files.push_back({*step, entry.path()});
  }
  std::sort(files.begin(), files.end(),
            [](const VtpFrameFile& a, const VtpFrameFile& b) { return a.step < b.step; });
  return files;
}

std::vector<VtpFrameFile> list_pvd_frames(const fs::path& path) {
  std::vector<VtpFrameFile> files;
  bool ascend = true;
  for (const PvdEntry& entry : read_pvd(path)) {
    const auto step = step_of(entry.file);
    ascend = ascend && step && (files.empty() || *step > files.back().step);
    files.push_back({step.value_or(0), path.parent_path() / entry.file});
  }
  for (std::size_t i = 0; i < files.size() && !ascend; ++i) files[i].step = static_cast<int>(i);
  return files;
}

}  // namespace ringlet
