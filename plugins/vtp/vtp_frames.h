#pragma once

#include <filesystem>
#include <vector>

namespace ringlet {

/// frames/frame_00012.vtp of a run folder.
struct VtpFrameFile {
  int step;
  std::filesystem::path path;
};

/// All of a run folder, by step.
std::vector<VtpFrameFile> list_vtp_frames(const std::filesystem::path& folder);

}  // namespace ringlet
