#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ringlet {

/// A file of one state of a run, such as frames/frame_00012.vtp.
struct FrameFile {
  int step;
  std::filesystem::path path;
};

/// frames/frame_<step>.EXTENSION, in a run folder.
std::string frame_name(int step, const std::string& extension);

/// The number at the end of a name, behind a '_'.
std::optional<int> step_in_name(const std::filesystem::path& path);

/// All of a run folder, by step.
std::vector<FrameFile> list_frame_files(const std::filesystem::path& folder,
                                        const std::string& extension);

/// For a run that goes on after a step, or -1, begins: removes all but those that observe() has
/// written every so many steps until then. Returns these.
std::vector<FrameFile> keep_frame_files(const std::filesystem::path& folder,
                                        const std::string& extension, int every, int last_step);

}  // namespace ringlet
