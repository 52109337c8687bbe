// Wavefront .obj: vertices `v x y z` and polylines `l a b c ...`, whose indices count from 1, or
// backwards from the last vertex so far if negative. Everything else in the file is skipped.
//
// Programs that export curves as meshes write each edge by itself: `l 1 2`, `l 2 3`, ... Single
// edges that follow each other in the file and on the curve are therefore joined to one strand.
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/error.h"
#include "core/readers/file_bytes.h"
#include "core/registry.h"
#include "core/strand_reader.h"

namespace ringlet {
namespace {

constexpr std::string_view blanks = " \t\r";

// Takes the first line off a text and splits it into words. A backslash at the end continues a line
// on the next. Returns how many lines that were.
int take_line(std::string_view& text, std::vector<std::string_view>& words) {
  words.clear();
  for (int lines = 1;; ++lines) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    line = line.substr(0, line.find_last_not_of(blanks) + 1);
    const bool continues = !line.empty() && line.back() == '\\';
    if (continues) line.remove_suffix(1);
    while ((line = line.substr(std::min(line.find_first_not_of(blanks), line.size()))) != "") {
      words.push_back(line.substr(0, line.find_first_of(blanks)));
      line.remove_prefix(words.back().size());
    }
    if (!continues || text.empty()) return lines;
  }
}

struct Polyline {
  std::vector<std::int64_t> vertices;  // counted from 0
  bool of_single_edges;
  int line;
};

class ObjParser {
 public:
  explicit ObjParser(const std::filesystem::path& file) : file_(file) {}

  Polylines parse() {
    const std::string content = read_bytes(file_);
    std::string_view text = content;
    std::vector<std::string_view> words;
    for (int lines = 0; !text.empty(); line_ += lines) {
      lines = take_line(text, words);
      if (words.empty()) continue;
      if (words[0] == "v") add_vertex(words);
      if (words[0] == "l") add_polyline(words);
    }
    return gather();
  }

 private:
  void add_vertex(const std::vector<std::string_view>& words) {
    Eigen::Vector3d vertex;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i + 1 >= words.size()) fail(line_, "expected a vertex 'v x y z'");
      vertex[static_cast<int>(i)] = number(words[i + 1]);
    }
    vertices_.push_back(vertex);
  }

  void add_polyline(const std::vector<std::string_view>& words) {
    Polyline polyline{{}, false, line_};
    for (std::size_t i = 1; i < words.size() && words[i].front() != '#'; ++i) {
      polyline.vertices.push_back(index(words[i]));
    }
    polyline.of_single_edges = polyline.vertices.size() == 2;
    const bool continues = polyline.of_single_edges && !polylines_.empty() &&
                           polylines_.back().of_single_edges &&
                           polylines_.back().vertices.back() == polyline.vertices.front();
    if (continues) {
      polylines_.back().vertices.push_back(polyline.vertices.back());
    } else {
      polylines_.push_back(std::move(polyline));
    }
  }

  // A double that fits a float: the square of anything larger might not be finite.
  double number(std::string_view word) const {
    double value = 0;
    const bool has_plus = word.front() == '+';  // which from_chars does not know
    const auto [end, failure] =
        std::from_chars(word.data() + has_plus, word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size() ||
        !(std::abs(value) <= std::numeric_limits<float>::max())) {
      fail(line_, "expected a finite number, found '" + std::string(word) + "'");
    }
    return value;
  }

  // Of `7`, `7/2`, `-1`: the vertex, counted from 0.
  std::int64_t index(std::string_view word) const {
    std::int64_t value = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool ends_well = end == word.data() + word.size() || *end == '/';
    if (failure != std::errc() || !ends_well || value == 0) {
      fail(line_, "expected the number of a vertex, found '" + std::string(word) + "'");
    }
    if (value > 0) return value - 1;
    const auto so_far = static_cast<std::int64_t>(vertices_.size());
    if (value < -so_far) {
      fail(line_, "expected one of the " + std::to_string(so_far) + " vertices so far, found '" +
                      std::string(word) + "'");
    }
    return so_far + value;
  }

  // A polyline may name vertices that stand further down in the file.
  Polylines gather() const {
    if (polylines_.empty()) fail(line_, "expected polylines 'l a b ...' in the file, found none");
    const auto count = static_cast<std::int64_t>(vertices_.size());
    Polylines result;
    for (const Polyline& polyline : polylines_) {
      result.vertex_counts.push_back(static_cast<int>(polyline.vertices.size()));
      for (const std::int64_t v : polyline.vertices) {
        if (v >= count) {
          fail(polyline.line, "expected a polyline of the file's " + std::to_string(count) +
                                  " vertices, found vertex " + std::to_string(v + 1));
        }
        result.positions.push_back(vertices_[static_cast<std::size_t>(v)]);
      }
    }
    return result;
  }

  [[noreturn]] void fail(int line, const std::string& problem) const {
    throw Error("'" + file_.string() + "', line " + std::to_string(line) + ": " + problem);
  }

  std::filesystem::path file_;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Polyline> polylines_;
  int line_ = 1;
};

class ObjReader final : public StrandReader {
 public:
  Polylines read(const std::filesystem::path& file) const override {
    return ObjParser(file).parse();
  }
};

}  // namespace

void register_obj_reader(Registry& registry) {
  registry.of<StrandReader>().add<NoParameters>(
      "obj", {"polylines of a Wavefront .obj, text", "", ""},
      [](const NoParameters&) { return std::make_unique<ObjReader>(); });
}

}  // namespace ringlet
