#pragma once

#include <string>
#include <vector>

namespace ringlet {

/// For what has no value of an axis, and for words of less weight.
inline constexpr const char* muted_colour = "#62666d";
/// Of the front, and darker for its words.
inline constexpr const char* front_colour = "#7fa8e8";
inline constexpr const char* front_text_colour = "#1d4f9e";

/// Colours "#rrggbb" for the values of an axis: a ramp if they are numbers or very many, else
/// colours as different as can be.
std::vector<std::string> colours_for(const std::vector<std::string>& values);

/// The number of a symbol of gnuplot's cairo terminal; the first is a circle, and after six they
/// begin anew. An index below zero is taken as the first.
int symbol_for(int index, bool filled);

}  // namespace ringlet
