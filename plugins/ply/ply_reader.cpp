#include "plugins/ply/ply_reader.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "plugins/ply/join_edges.h"
#include "plugins/ply/ply_header.h"

namespace ringlet {
namespace {

class PlyParser {
 public:
  explicit PlyParser(const std::filesystem::path& file)
      : bytes_(file), header_(take_ply_header(bytes_)) {}

  Polylines parse() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        take_vertices(element);
      } else if (element.name == "edge") {
        take_edges(element);
      } else {
        for (std::int64_t i = 0; i < element.count; ++i) take_row(element);
      }
    }
    if (vertices_.positions.empty()) bytes_.fail("expected elements 'vertex' in the file");
    if (edges_.empty())
      bytes_.fail("expected elements 'edge' in the file, which join the vertices");
    check_edges();
    if (const auto problem = join_edges(edges_, vertices_)) {
      bytes_.fail("expected edges that make strands, but of vertex " +
                  std::to_string(problem->vertex) + ": " + problem->reason);
    }
    return std::move(vertices_);
  }

 private:
  void take_vertices(const PlyElement& element) {
    const std::array<int, 3> places = find(element, std::array{"x", "y", "z"});
    const int radius = element.find("radius");
    for (std::int64_t i = 0; i < element.count; ++i) {
      take_row(element);
      Eigen::Vector3d x;
      for (int c = 0; c < 3; ++c) {
        x[c] = row_[static_cast<std::size_t>(places[static_cast<std::size_t>(c)])];
      }
      // The square of anything larger than a float might not be finite.
      if (!x.allFinite() || x.cwiseAbs().maxCoeff() > std::numeric_limits<float>::max()) {
        bytes_.fail("expected vertices with finite coordinates, found another as vertex " +
                    std::to_string(i));
      }
      vertices_.positions.push_back(x);
      if (radius >= 0) add_radius(row_[static_cast<std::size_t>(radius)]);
    }
  }

  void add_radius(double radius) {
    if (!(radius >= 0) || !std::isfinite(radius)) {
      bytes_.fail("expected finite radii >= 0, found another at vertex " +
                  std::to_string(vertices_.radii.size()));
    }
    vertices_.radii.push_back(radius);
  }

  void take_edges(const PlyElement& element) {
    const std::array<int, 2> places = find(element, std::array{"vertex1", "vertex2"});
    for (std::int64_t i = 0; i < element.count; ++i) {
      take_row(element);
      VertexPair edge;
      for (std::size_t end = 0; end < 2; ++end) {
        const double vertex = row_[static_cast<std::size_t>(places[end])];
        const bool is_number = vertex >= 0 && vertex <= std::numeric_limits<int>::max();
        if (!is_number) bytes_.fail("expected numbers of vertices in edge " + std::to_string(i));
        edge[end] = static_cast<int>(vertex);
      }
      edges_.push_back(edge);
    }
  }

  void check_edges() const {
    for (const VertexPair& edge : edges_) {
      for (const int vertex : edge) {
        if (static_cast<std::size_t>(vertex) < vertices_.positions.size()) continue;
        bytes_.fail("expected edges between the file's " +
                    std::to_string(vertices_.positions.size()) + " vertices, found vertex " +
                    std::to_string(vertex));
      }
    }
  }

  template <std::size_t N>
  std::array<int, N> find(const PlyElement& element,
                          const std::array<const char*, N>& names) const {
    std::array<int, N> places{};
    for (std::size_t i = 0; i < N; ++i) {
      places[i] = element.find(names[i]);
      if (places[i] < 0) {
        bytes_.fail("expected a property '" + std::string(names[i]) + "' of the element '" +
                    element.name + "'");
      }
    }
    return places;
  }

  /// The properties of the next element; lists are skipped.
  void take_row(const PlyElement& element) {
    row_.assign(element.properties.size(), 0);
    for (std::size_t i = 0; i < row_.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.is_list) {
        const double length = take(property.count_type);
        for (double n = 0; n < length; ++n) take(property.type);
      } else {
        row_[i] = take(property.type);
      }
    }
  }

  double take(PlyType type) {
    if (header_.is_ascii) return take_word();
    switch (type) {
      case PlyType::int8:
        return bytes_.take<std::int8_t>("a number");
      case PlyType::uint8:
        return bytes_.take<std::uint8_t>("a number");
      case PlyType::int16:
        return bytes_.take<std::int16_t>("a number");
      case PlyType::uint16:
        return bytes_.take<std::uint16_t>("a number");
      case PlyType::int32:
        return bytes_.take<std::int32_t>("a number");
      case PlyType::uint32:
        return bytes_.take<std::uint32_t>("a number");
      case PlyType::float32:
        return static_cast<double>(bytes_.take<float>("a number"));
      default:
        return bytes_.take<double>("a number");
    }
  }

  double take_word() {
    const auto is_blank = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
    std::string word;
    while (word.empty() || bytes_.left() > 0) {
      const char letter = bytes_.take<char>("a number");
      if (!is_blank(letter)) {
        word += letter;
      } else if (!word.empty()) {
        break;
      }
    }
    double value = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size()) {
      bytes_.fail("expected a number, found '" + word.substr(0, 40) + "'");
    }
    return value;
  }

  FileBytes bytes_;
  PlyHeader header_;
  std::vector<double> row_;
  Polylines vertices_;
  std::vector<VertexPair> edges_;
};

}  // namespace

Polylines PlyReader::read(const std::filesystem::path& file) const {
  return PlyParser(file).parse();
}

}  // namespace ringlet
