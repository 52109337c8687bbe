#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "plugins/usda/usda_text.h"

namespace ringlet {

/// The strands of a .usda file: its one BasisCurves, linear and not periodic, in metres with +y up
/// whatever unit and axis the file has. Transforms of prims are refused, all else is skipped.
class UsdaReader {
 public:
  /// Throws Error with file, line and what was expected there.
  explicit UsdaReader(const std::filesystem::path& file);
  UsdaReader(const UsdaReader&) = delete;
  UsdaReader& operator=(const UsdaReader&) = delete;

  const std::vector<int>& vertex_counts() const { return vertex_counts_; }
  const std::vector<double>& radii() const { return radii_; }  ///< m; of each vertex, or none
  /// Of each time sample, s; one 0 where the points do not change.
  const std::vector<double>& times() const { return times_; }
  /// The positions of a time sample, m. Throws Error as the constructor does.
  Eigen::Matrix3Xd read(int sample);

 private:
  void take_layer();
  void take_prim(int depth);
  void take_property(std::string name, bool is_of_curves);
  void take_value_of_curves(const std::string& name);
  void take_text(const std::string& name, const std::string& expected);
  void take_vertex_counts();
  void take_samples();
  void set_radii();

  std::string bytes_;
  UsdaText text_;
  double metres_per_unit_ = 0.01, time_codes_per_second_ = 24;  ///< as where a file has none
  bool is_z_up_ = false;
  bool is_linear_ = false;
  bool has_curves_ = false;
  std::vector<int> vertex_counts_;
  std::size_t vertices_ = 0;
  std::vector<double> widths_, radii_, times_;
  std::vector<std::size_t> places_;  ///< where each sample stands in the text
};

}  // namespace ringlet
