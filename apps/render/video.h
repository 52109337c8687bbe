#pragma once

#include <filesystem>
#include <vector>

namespace ringlet {

/// Throws Error if there is no ffmpeg, and says how to get it.
void require_ffmpeg();

/// Joins pictures into a video in which each is seen for some seconds. The kind of video follows
/// from the name of the file, which appears whole or not at all. Throws Error if ffmpeg fails.
void make_video(const std::vector<std::filesystem::path>& pictures, double seconds_each,
                const std::filesystem::path& video);

}  // namespace ringlet
