#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ringlet {

/// A state of a run, as a writer kept it.
struct RunFrame {
  int step;
  double time;                 ///< s
  Eigen::Matrix3Xd positions;  ///< column i = vertex i, m
};

/// The frames of a run folder: of frames.bin, or where that is not there of
/// frames/frame_<step>.vtp; or those of a file of either kind, .bin or .pvd.
class RunFrames {
 public:
  /// Throws Error if there is no frame, or if frames.bin is damaged.
  explicit RunFrames(const std::filesystem::path& run);
  ~RunFrames();
  RunFrames(const RunFrames&) = delete;
  RunFrames& operator=(const RunFrames&) = delete;

  const std::vector<int>& vertex_counts() const;  ///< of each strand
  const std::vector<double>& radii() const;       ///< m, one a vertex
  const std::vector<int>& steps() const;          ///< of the frames, ascending
  /// Why frames at the end are not among them: the last one of a run that was killed may be torn.
  const std::vector<std::string>& left_out() const;
  /// The number-th frame. Throws Error if it is damaged, or is of other strands.
  RunFrame read(int number);

  /// How one kind of files is read.
  class Source;

 private:
  std::unique_ptr<Source> source_;
};

}  // namespace ringlet
