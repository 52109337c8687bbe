#include "plugins/usda/usda_reader.h"

#include <limits>

#include "core/readers/file_bytes.h"

namespace ringlet {
namespace {

constexpr int deepest_prim = 100;

}  // namespace

UsdaReader::UsdaReader(const std::filesystem::path& file)
    : bytes_(read_bytes(file)), text_(file, bytes_) {
  if (!bytes_.starts_with("#usda 1.0")) text_.fail("expected '#usda 1.0' at the beginning");
  if (text_.take('(')) take_layer();
  while (text_.peek() != '\0') {
    text_.take_name();  // def, over or class
    take_prim(0);
  }
  if (places_.empty() || vertex_counts_.empty()) {
    text_.fail("expected BasisCurves with curveVertexCounts and points in the file");
  }
  if (!is_linear_) text_.fail("expected curves of the type \"linear\"");
  for (double& time : times_) time /= time_codes_per_second_;
  set_radii();
}

void UsdaReader::take_layer() {
  while (!text_.take(')')) {
    if (text_.peek() == '"' || text_.peek() == '\'') {
      text_.take_string();
      continue;
    }
    std::string name;
    for (std::string word; !(word = text_.take_name()).empty();) name = word;
    if (name.empty()) text_.fail("expected a key or ')'");
    text_.expect('=');
    if (name == "metersPerUnit") {
      metres_per_unit_ = text_.take_number();
      if (!(metres_per_unit_ > 0)) text_.fail("expected metersPerUnit > 0");
    } else if (name == "timeCodesPerSecond") {
      time_codes_per_second_ = text_.take_number();
      if (!(time_codes_per_second_ > 0)) text_.fail("expected timeCodesPerSecond > 0");
    } else if (name == "upAxis") {
      is_z_up_ = text_.take_string() == "Z";
    } else {
      text_.skip_value();
    }
  }
}

void UsdaReader::take_prim(int depth) {
  if (depth > deepest_prim) text_.fail("expected prims less deep in each other");
  const bool is_of_curves = text_.take_name() == "BasisCurves";
  if (is_of_curves && has_curves_) text_.fail("expected one BasisCurves, found another");
  has_curves_ |= is_of_curves;
  text_.take_string();
  if (text_.peek() == '(') text_.skip_value();
  text_.expect('{');
  while (!text_.take('}')) {
    std::string name = text_.take_name();
    if (name == "def" || name == "over" || name == "class") {
      take_prim(depth + 1);
    } else if (name == "variantSet") {
      text_.take_string();
      text_.expect('=');
      text_.skip_value();
    } else {
      take_property(std::move(name), is_of_curves);
    }
  }
}

void UsdaReader::take_property(std::string name, bool is_of_curves) {
  if (name.empty()) text_.fail("expected a property");
  for (std::string word; !(word = text_.take_name()).empty();) name = word;
  if (name.starts_with("xformOp")) {
    text_.fail("expected curves without transforms, found '" + name + "'");
  }
  if (text_.take('=')) {
    if (is_of_curves) {
      take_value_of_curves(name);
    } else {
      text_.skip_value();
    }
  }
  if (text_.peek() == '(') text_.skip_value();
}

void UsdaReader::take_value_of_curves(const std::string& name) {
  if (name == "type") {
    take_text(name, "linear");
    is_linear_ = true;
  } else if (name == "wrap") {
    take_text(name, "nonperiodic");
  } else if (name == "curveVertexCounts") {
    take_vertex_counts();
  } else if (name == "widths") {
    widths_ = text_.take_numbers();
  } else if (name == "points.timeSamples") {
    take_samples();
  } else {
    if (name == "points" && places_.empty()) {
      places_ = {text_.place()};
      times_ = {0};
    }
    text_.skip_value();
  }
}

void UsdaReader::take_text(const std::string& name, const std::string& expected) {
  const std::string found = text_.take_string();
  if (found == expected) return;
  text_.fail("expected curves of the " + name + " \"" + expected + "\", found \"" + found + "\"");
}

void UsdaReader::take_vertex_counts() {
  vertex_counts_.clear();
  vertices_ = 0;
  for (const double count : text_.take_numbers()) {
    if (!(count >= 1 && count <= std::numeric_limits<int>::max())) {
      text_.fail("expected numbers of vertices from 1 to 2^31 - 1");
    }
    vertex_counts_.push_back(static_cast<int>(count));
    vertices_ += static_cast<std::size_t>(vertex_counts_.back());
  }
}

void UsdaReader::take_samples() {
  places_.clear();
  times_.clear();
  text_.expect('{');
  while (!text_.take('}')) {
    times_.push_back(text_.take_number());
    if (times_.size() > 1 && !(times_.back() > times_[times_.size() - 2])) {
      text_.fail("expected time samples in ascending order");
    }
    text_.expect(':');
    places_.push_back(text_.place());
    text_.skip_value();
    if (!text_.take(',') && text_.peek() != '}') text_.fail("expected ',' or '}'");
  }
}

// There may be a width for all, one a curve, or one a vertex.
void UsdaReader::set_radii() {
  if (widths_.empty()) return;
  const std::size_t count = widths_.size();
  if (count != 1 && count != vertices_ && count != vertex_counts_.size()) {
    text_.fail("expected widths of " + std::to_string(vertices_) + " vertices in all, found " +
               std::to_string(count));
  }
  std::size_t vertex = 0;
  for (std::size_t curve = 0; curve < vertex_counts_.size(); ++curve) {
    for (int i = 0; i < vertex_counts_[curve]; ++i, ++vertex) {
      const double width = widths_[count == 1 ? 0 : count == vertices_ ? vertex : curve];
      if (!(width >= 0)) text_.fail("expected widths >= 0");
      radii_.push_back(0.5 * width * metres_per_unit_);
    }
  }
}

Eigen::Matrix3Xd UsdaReader::read(int sample) {
  text_.go_to(places_.at(static_cast<std::size_t>(sample)));
  std::vector<Eigen::Vector3d> points = text_.take_points();
  if (points.size() != vertices_) {
    text_.fail("expected " + std::to_string(vertices_) +
               " points, as curveVertexCounts says, found " + std::to_string(points.size()));
  }
  for (Eigen::Vector3d& x : points) {
    if (is_z_up_) x = {x[0], x[2], -x[1]};
    x *= metres_per_unit_;
  }
  return Eigen::Map<const Eigen::Matrix3Xd>(points[0].data(), 3,
                                            static_cast<Eigen::Index>(points.size()));
}

}  // namespace ringlet
