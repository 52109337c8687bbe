#pragma once

#include <string>

#include "apps/study/picture/data.h"
#include "apps/study/picture/log_range.h"

namespace ringlet {

/// Where things are in the picture, in pixels; upwards from the lower left corner, as for gnuplot.
namespace layout {
inline constexpr double width = 1400, height = 900;
inline constexpr double left = 112, right = 890, bottom = 172, top = 790;
inline constexpr double side = 922;  ///< where the list beside the plot begins
}  // namespace layout

/// Both ranges of the plot, and where a point lies in the picture.
struct PictureFrame {
  LogRange seconds, values;

  explicit PictureFrame(const PictureData& data);
  /// Zero stands on the lower edge.
  double shown_value(const PicturePoint& point) const;
  double x(const PicturePoint& point) const;
  double y(const PicturePoint& point) const;
};

/// The command that writes a text at a pixel.
std::string label_command(const std::string& text, double x, double y, int size,
                          const std::string& options = "left");

/// The command that draws a symbol at a pixel.
std::string mark_command(int symbol, const std::string& colour, double size, double x, double y);

}  // namespace ringlet
