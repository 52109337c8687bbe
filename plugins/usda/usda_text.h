#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ringlet {

/// Walks through the text of a .usda file: blanks and comments are passed over, and every error
/// names the file and the line. The text must outlive it.
class UsdaText {
 public:
  UsdaText(std::filesystem::path file, std::string_view text)
      : file_(std::move(file)), text_(text) {}

  /// The next letter after blanks and comments, which stays there; 0 at the end.
  char peek();
  /// Takes a letter, if it is the next.
  bool take(char letter);
  /// Throws Error if another letter is next.
  void expect(char letter);
  /// A name, with its namespaces and brackets: point3f[], points.timeSamples; "" if none is next.
  std::string take_name();
  /// Throws Error if there is none, as all of these.
  double take_number();
  std::string take_string();
  /// [a, b, ...]
  std::vector<double> take_numbers();
  /// [(x, y, z), ...]
  std::vector<Eigen::Vector3d> take_points();
  /// Passes over a value of any kind, with all that is in its brackets.
  void skip_value();

  std::size_t place() const { return at_; }
  void go_to(std::size_t place) { at_ = place; }
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  void skip_blanks();
  void skip_past(char letter);
  void skip_word();

  std::filesystem::path file_;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace ringlet
