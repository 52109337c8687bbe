#include "collision/colliders/obj_mesh.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"

namespace ringlet {
namespace {

// A coordinate beyond this is no length in metres, and its powers would overflow.
constexpr double largest_coordinate = 1e9;

std::string_view next_word(std::string_view& line) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
  const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

template <class Number>
std::optional<Number> parse(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return number;
}

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& path) : path_(path), file_(path) {
    if (!file_) throw Error("cannot open '" + path.string() + "'");
  }

  IndexedTriangles read() {
    std::string line;
    while (std::getline(file_, line)) {
      ++line_number_;
      std::string_view rest = line;
      const std::string_view keyword = next_word(rest);
      if (keyword == "v") read_vertex(rest);
      if (keyword == "f") read_face(rest);
    }
    if (mesh_.triangles.empty()) throw Error("'" + path_.string() + "' has no face ('f a b c')");
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error("'" + path_.string() + "', line " + std::to_string(line_number_) + ": " + what);
  }

  void read_vertex(std::string_view rest) {
    Eigen::Vector3d position;
    for (double& coordinate : position) {
      const std::string_view word = next_word(rest);
      const auto number = parse<double>(word);
      if (!number || !(std::abs(*number) <= largest_coordinate)) {
        fail("expected three coordinates in m, found '" + std::string(word) + "'");
      }
      coordinate = *number;
    }
    mesh_.vertices.push_back(position);
  }

  // "7", "7/2", "7//3" and "7/2/3" all name vertex 7; -1 is the last one before this line.
  int read_index(std::string_view word) const {
    const auto number = parse<long long>(word.substr(0, word.find('/')));
    if (!number) fail("expected the index of a vertex, found '" + std::string(word) + "'");
    const auto count = static_cast<long long>(mesh_.vertices.size());
    const long long index = *number < 0 ? count + *number : *number - 1;
    if (index < 0 || index >= count) {
      fail("the face names vertex " + std::to_string(*number) + ", but there are " +
           std::to_string(count) + " before it");
    }
    return static_cast<int>(index);
  }

  void read_face(std::string_view rest) {
    std::vector<int> corners;
    for (auto word = next_word(rest); !word.empty() && word[0] != '#'; word = next_word(rest)) {
      corners.push_back(read_index(word));
    }
    if (corners.size() < 3) {
      fail("a face needs at least three vertices, found " + std::to_string(corners.size()));
    }
    for (std::size_t n = 2; n < corners.size(); ++n) {
      mesh_.triangles.push_back({corners[0], corners[n - 1], corners[n]});
    }
  }

  const std::filesystem::path& path_;
  std::ifstream file_;
  int line_number_ = 0;
  IndexedTriangles mesh_;
};

}  // namespace

IndexedTriangles read_obj_mesh(const std::filesystem::path& path) { return ObjReader(path).read(); }

}  // namespace ringlet
