#pragma once

#include <filesystem>

#include "core/parameters.h"

namespace ringlet {

/// Draws the results of a study (what results.json holds) as a PNG file of 1400 x 900 pixels: its
/// first error against time, both logarithmic, with the Pareto front. Gnuplot draws it, as a
/// program of its own. Throws Error if there is no gnuplot, and says how to get it, if gnuplot
/// fails, or if the file cannot be written; an older file is then as it was.
void draw_study(const Json& results, const std::filesystem::path& png);

}  // namespace ringlet
