#include "apps/study/picture/text.h"

#include <algorithm>
#include <sstream>

namespace ringlet {
namespace {

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

std::size_t count_characters(const std::string& text) {
  return text.size() -
         static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues_character));
}

/// Where a character begins; the end of the text if it has fewer.
std::size_t find_character(const std::string& text, std::size_t number) {
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    if (!continues_character(text[at]) && number-- == 0) break;
  }
  return at;
}

}  // namespace

std::string gnuplot_string(const std::string& text) {
  std::string quoted = "'";
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    quoted += code < 0x20 || code == 0x7F ? ' ' : character;
    if (character == '\'') quoted += '\'';
  }
  return quoted + "'";
}

std::string shortened(const std::string& text, std::size_t most) {
  if (count_characters(text) <= most) return text;
  return text.substr(0, find_character(text, most - 1)) + "…";
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width,
                                 std::size_t most_lines) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits =
        !lines.empty() && count_characters(lines.back()) + 1 + count_characters(word) <= width;
    if (fits) {
      lines.back() += " " + word;
    } else if (lines.size() < most_lines) {
      lines.push_back(shortened(word, width));
    } else {
      lines.back() = shortened(lines.back(), width - 2) + " …";
      break;
    }
  }
  return lines;
}

}  // namespace ringlet
