#include "plugins/usda/usda_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace ringlet {
namespace {

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == ':' || c == '.';
}

}  // namespace

void UsdaText::skip_blanks() {
  while (at_ < text_.size()) {
    if (text_[at_] == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (std::string_view(" \t\r\n;").find(text_[at_]) != std::string_view::npos) {
      ++at_;
    } else {
      return;
    }
  }
}

char UsdaText::peek() {
  skip_blanks();
  return at_ < text_.size() ? text_[at_] : '\0';
}

bool UsdaText::take(char letter) {
  if (peek() != letter || at_ == text_.size()) return false;
  ++at_;
  return true;
}

void UsdaText::expect(char letter) {
  if (!take(letter)) fail(std::string("expected '") + letter + "'");
}

std::string UsdaText::take_name() {
  skip_blanks();
  std::string name;
  while (at_ < text_.size() && (is_of_name(text_[at_]) || text_.substr(at_, 2) == "[]")) {
    const std::size_t letters = text_[at_] == '[' ? 2 : 1;
    name += text_.substr(at_, letters);
    at_ += letters;
  }
  return name;
}

double UsdaText::take_number() {
  skip_blanks();
  double value = 0;
  const char* end_of_text = text_.data() + text_.size();
  const auto [end, failure] = std::from_chars(text_.data() + at_, end_of_text, value);
  // The square of anything larger than a float might not be finite.
  if (failure != std::errc() || !(std::abs(value) <= std::numeric_limits<float>::max())) {
    fail("expected a finite number");
  }
  at_ = static_cast<std::size_t>(end - text_.data());
  return value;
}

std::string UsdaText::take_string() {
  const char quote = peek();
  if (quote != '"' && quote != '\'') fail("expected a text in quotes");
  const std::string three(3, quote);
  const std::string mark = text_.substr(at_, 3) == three ? three : std::string(1, quote);
  const std::size_t begin = at_ + mark.size();
  std::size_t end = text_.find(mark, begin);
  while (end != std::string_view::npos && text_[end - 1] == '\\') end = text_.find(mark, end + 1);
  if (end == std::string_view::npos) fail("expected the other quote of a text");
  at_ = end + mark.size();
  return std::string(text_.substr(begin, end - begin));
}

std::vector<double> UsdaText::take_numbers() {
  std::vector<double> numbers;
  expect('[');
  while (!take(']')) {
    numbers.push_back(take_number());
    if (!take(',') && peek() != ']') fail("expected ',' or ']'");
  }
  return numbers;
}

std::vector<Eigen::Vector3d> UsdaText::take_points() {
  std::vector<Eigen::Vector3d> points;
  expect('[');
  while (!take(']')) {
    Eigen::Vector3d& x = points.emplace_back();
    for (int c = 0; c < 3; ++c) {
      expect(c == 0 ? '(' : ',');
      x[c] = take_number();
    }
    expect(')');
    if (!take(',') && peek() != ']') fail("expected ',' or ']'");
  }
  return points;
}

void UsdaText::skip_value() {
  const std::string_view opening = "([{", closing = ")]}";
  std::string open;  // what closes the brackets around this place
  do {
    const char next = peek();
    const std::size_t kind = opening.find(next);
    if (at_ == text_.size()) fail("expected a value, found the end of the file");
    if (next == '"' || next == '\'') {
      take_string();
    } else if (next == '<' || next == '@') {
      skip_past(next == '<' ? '>' : '@');
    } else if (kind != std::string_view::npos) {
      open += closing[kind];
      ++at_;
    } else if (!open.empty() && next == open.back()) {
      open.pop_back();
      ++at_;
    } else if (closing.find(next) != std::string_view::npos) {
      fail(std::string("expected a value, found '") + next + "'");
    } else {
      skip_word();
    }
  } while (!open.empty());
}

void UsdaText::skip_past(char letter) {
  const std::size_t found = text_.find(letter, at_ + 1);
  if (found == std::string_view::npos) fail(std::string("expected a '") + letter + "' further on");
  at_ = found + 1;
}

void UsdaText::skip_word() {
  do ++at_;
  while (at_ < text_.size() && (is_of_name(text_[at_]) || text_[at_] == '-' || text_[at_] == '+'));
}

void UsdaText::fail(const std::string& problem) const {
  const auto line =
      std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
  throw Error("'" + file_.string() + "', line " + std::to_string(line + 1) + ": " + problem);
}

}  // namespace ringlet
