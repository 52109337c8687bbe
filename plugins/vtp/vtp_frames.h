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

/// Those of a .pvd. Their steps are the numbers at the end of their names, or where these do not
/// ascend, as in a .pvd of another program, their places from 0 on. Throws Error if it is not
/// whole.
std::vector<VtpFrameFile> list_pvd_frames(const std::filesystem::path& path);

}  // namespace ringlet
