#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "core/named.h"

namespace ringlet {

/// Polylines as a file holds them, in the file's own unit. A strand may have a single vertex, or
/// none.
struct Polylines {
  std::vector<int> vertex_counts;          ///< of each strand, root first
  std::vector<Eigen::Vector3d> positions;  ///< finite; all vertices, strand after strand
  std::vector<double> radii;               ///< finite, >= 0; of each vertex, or none
};

/// Reads the strands of a file format. A reader is registered under the extension of its files
/// without the dot. It treats a file as hostile: counts are checked against the size of the file
/// before anything is allocated for them.
class StrandReader : public Named {
 public:
  virtual ~StrandReader() = default;
  /// Throws Error with file, place, and what was expected there.
  virtual Polylines read(const std::filesystem::path& file) const = 0;
};

}  // namespace ringlet
