#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/parameters.h"

namespace ringlet {

class Strands;

/// A number that may differ from place to place of the strands: one for all, one a strand, one a
/// vertex, or some at equal distances along each strand, linear between them.
class Varying {
 public:
  Varying() = default;
  Varying(double everywhere) : numbers_{everywhere} {}  // NOLINT(*-explicit-*)

  /// The number at a vertex. Throws Error if there is not one for each strand or vertex.
  double at(const Strands& strands, int vertex) const;
  /// Whether it is the same all along a strand.
  bool is_constant_along() const { return by_ == By::all || by_ == By::strand; }

 private:
  friend struct Codec<Varying>;
  enum class By { all, strand, vertex, length };

  double number_of(int which, int expected, const char* what) const;

  By by_ = By::all;
  std::vector<double> numbers_{0};
  std::string pointer_;         ///< where the scene has it, for errors
  std::filesystem::path file_;  ///< of the numbers; empty: the scene has them
};

/// A number, or an object with one key: "by_strand" or "by_vertex" (a list, or the path of a text
/// file of numbers), or "root_to_tip" (a list).
template <>
struct Codec<Varying> {
  static std::string type() {
    return "number, or {\"by_strand\", \"by_vertex\" or \"root_to_tip\"}";
  }
  static Json schema(const KeyInfo& key);
  static void read(const Json&, const std::string& pointer, const KeyInfo&, ParseContext&,
                   Varying&);
  static Json write(const Varying&);

 private:
  static void read_list(const Json&, const std::string& pointer, const KeyInfo&, ParseContext&,
                        Varying&);
  static void read_file(const Json&, const std::string& pointer, const KeyInfo&, ParseContext&,
                        Varying&);
};

}  // namespace ringlet
