#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <fstream>

#include "plugins/frames/frames_format.h"

namespace ringlet {

/// One state of a run.
struct StoredFrame {
  std::int64_t step;
  double time;                 ///< s
  Eigen::Matrix3Xd positions;  ///< column i = vertex i, m
};

/// Reads frames.bin, also while it is written. Trusts nothing in it.
class FramesReader {
 public:
  /// Throws Error if the file cannot be read, or is no such file.
  explicit FramesReader(std::filesystem::path path);

  const FramesHeader& header() const { return header_; }
  const std::vector<double>& radii() const { return radii_; }  ///< m, one a vertex
  /// Complete frames, as many as there are now.
  int count() const;
  /// Of a file that holds the first frames and no more.
  std::int64_t bytes_with(int frames) const {
    return first_frame_ + frames * header_.frame_bytes();
  }
  /// Of a frame. Throws Error if there is no such frame.
  std::int64_t step(int frame);
  /// Throws Error if there is no such frame, or if its checksum is wrong.
  StoredFrame read(int frame);

 private:
  [[noreturn]] void fail(const std::string& what) const;
  void read_header();
  void read_radii(const std::string& header);
  std::string read_bytes(int frame, std::int64_t count);

  std::filesystem::path path_;
  std::ifstream file_;
  FramesHeader header_;
  std::vector<double> radii_;
  std::int64_t first_frame_ = 0;  ///< its place in the file
};

}  // namespace ringlet
