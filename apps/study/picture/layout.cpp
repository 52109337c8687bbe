#include "apps/study/picture/layout.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "apps/study/picture/text.h"

namespace ringlet {
namespace {

std::string at_pixel(double x, double y) {
  return fmt::format("at screen {:.5f},{:.5f}", x / layout::width, y / layout::height);
}

double share(const LogRange& range, double value) {
  return std::log(value / range.low) / std::log(range.high / range.low);
}

}  // namespace

PictureFrame::PictureFrame(const PictureData& data) {
  std::vector<double> all_seconds, all_values;
  for (const PicturePoint& point : data.points) {
    all_seconds.insert(all_seconds.end(), {point.seconds, point.seconds_low, point.seconds_high});
    if (point.value > 0) all_values.push_back(point.value);
  }
  seconds = LogRange::around(all_seconds);
  values = LogRange::around(all_values);
}

double PictureFrame::shown_value(const PicturePoint& point) const {
  return point.value > 0 ? point.value : values.low;
}

double PictureFrame::x(const PicturePoint& point) const {
  return layout::left + (layout::right - layout::left) * share(seconds, point.seconds);
}

double PictureFrame::y(const PicturePoint& point) const {
  return layout::bottom + (layout::top - layout::bottom) * share(values, shown_value(point));
}

std::string label_command(const std::string& text, double x, double y, int size,
                          const std::string& options) {
  return fmt::format("set label {} {} font ',{}' {}\n", gnuplot_string(text), at_pixel(x, y), size,
                     options);
}

std::string mark_command(int symbol, const std::string& colour, double size, double x, double y) {
  return fmt::format("set label '' {} point pt {} ps {} lc rgb '{}' front\n", at_pixel(x, y),
                     symbol, size, colour);
}

}  // namespace ringlet
