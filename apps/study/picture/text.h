#pragma once

#include <string>
#include <vector>

namespace ringlet {

/// A text as gnuplot reads it: in single quotes, within which nothing but a quote has a meaning,
/// and on one line.
std::string gnuplot_string(const std::string& text);

/// At most so many characters of UTF-8; what is longer ends in "…".
std::string shortened(const std::string& text, std::size_t most);

/// Lines of at most so many characters, broken at spaces. Of more than `most_lines` the last ends
/// in "…".
std::vector<std::string> wrapped(const std::string& text, std::size_t width,
                                 std::size_t most_lines);

}  // namespace ringlet
