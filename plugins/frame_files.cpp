#include "plugins/frame_files.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace ringlet {
namespace {

namespace fs = std::filesystem;

bool is_frame(const fs::path& path, const std::string& extension) {
  const std::string stem = path.stem().string(), start = "frame_";
  return path.extension() == "." + extension && stem.starts_with(start) &&
         stem.rfind('_') + 1 == start.size();
}

}  // namespace

std::string frame_name(int step, const std::string& extension) {
  return fmt::format("frames/frame_{:05}.{}", step, extension);
}

std::optional<int> step_in_name(const fs::path& path) {
  const std::string stem = path.stem().string();
  const std::string digits = stem.substr(stem.rfind('_') + 1);
  if (digits.empty() || digits.size() > 9 ||
      !std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    return {};
  }
  return std::stoi(digits);
}

std::vector<FrameFile> list_frame_files(const fs::path& folder, const std::string& extension) {
  std::vector<FrameFile> files;
  if (!fs::is_directory(folder / "frames")) return files;
  for (const auto& entry : fs::directory_iterator(folder / "frames")) {
    if (!is_frame(entry.path(), extension)) continue;
    if (const auto step = step_in_name(entry.path())) files.push_back({*step, entry.path()});
  }
  std::sort(files.begin(), files.end(),
            [](const FrameFile& a, const FrameFile& b) { return a.step < b.step; });
  return files;
}

std::vector<FrameFile> keep_frame_files(const fs::path& folder, const std::string& extension,
                                        int every, int last_step) {
  std::vector<FrameFile> kept;
  for (const FrameFile& file : list_frame_files(folder, extension)) {
    if (file.step > last_step || file.step % every != 0) {
      fs::remove(file.path);
    } else {
      kept.push_back(file);
    }
  }
  return kept;
}

}  // namespace ringlet
