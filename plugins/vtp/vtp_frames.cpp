#include "plugins/vtp/vtp_frames.h"

#include <algorithm>
#include <optional>
#include <string>

namespace ringlet {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

std::vector<VtpFrameFile> list_vtp_frames(const fs::path& folder) {
  std::vector<VtpFrameFile> files;
  if (!fs::is_directory(folder / "frames")) return files;
  for (const auto& entry : fs::directory_iterator(folder / "frames")) {
    if (const auto step = step_of(entry.path())) files.push_back({*step, entry.path()});
  }
  std::sort(files.begin(), files.end(),
            [](const VtpFrameFile& a, const VtpFrameFile& b) { return a.step < b.step; });
  return files;
}

}  // namespace ringlet
