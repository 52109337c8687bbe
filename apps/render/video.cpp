#include "apps/render/video.h"

#include <spdlog/fmt/fmt.h>

#include "apps/study/picture/child_program.h"
#include "core/error.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

/// As ffmpeg's list of files has it.
std::string quoted(const std::string& text) {
  std::string quoted_text = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted_text += "'\\''";
    } else {
      quoted_text += c;
    }
  }
  return quoted_text + "'";
}

std::string list_of(const std::vector<fs::path>& pictures, double seconds_each) {
  std::string list = "ffconcat version 1.0\n";
  for (const fs::path& picture : pictures) {
    // Without "file:" they would be looked for where the list comes from, in the pipe.
    list += fmt::format("file {}\nduration {:.9f}\n",
                        quoted("file:" + fs::absolute(picture).string()), seconds_each);
  }
  return list;
}

fs::path unfinished(const fs::path& video) {
  return video.parent_path() / (video.stem().string() + ".part" + video.extension().string());
}

[[noreturn]] void fail(const fs::path& video, const std::string& reason) {
  throw Error("ffmpeg could not write '" + video.string() + "': " + reason);
}

}  // namespace

void require_ffmpeg() {
  if (run_program({"ffmpeg", "-version"}, "")) return;
  throw Error("there is no ffmpeg, which makes videos; install ffmpeg, or leave out --video");
}

void make_video(const std::vector<fs::path>& pictures, double seconds_each, const fs::path& video) {
  const fs::path part = unfinished(video);
  // Many players ask for an even number of pixels, and half of them for the colours.
  const auto done = run_program(
      {"ffmpeg", "-y", "-loglevel", "error", "-f", "concat", "-safe", "0", "-protocol_whitelist",
       "file,pipe", "-i", "pipe:0", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-r",
       fmt::format("{:.6f}", 1 / seconds_each), "-pix_fmt", "yuv420p", part.string()},
      list_of(pictures, seconds_each));
  std::error_code error;
  if (done && done->exit_code == 0) fs::rename(part, video, error);
  if (done && done->exit_code == 0 && !error) return;
  std::error_code ignored;
  fs::remove(part, ignored);
  fail(video, !done ? "there is no ffmpeg" : error ? error.message() : done->errors);
}

}  // namespace ringlet
