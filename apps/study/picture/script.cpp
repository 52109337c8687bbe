#include "apps/study/picture/script.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/study/picture/layout.h"
#include "apps/study/picture/quantity_words.h"
#include "apps/study/picture/symbols.h"
#include "apps/study/picture/text.h"
#include "apps/study/picture/words.h"

namespace ringlet {
namespace {

using namespace layout;

std::string axis(char name, const LogRange& range, const std::string& unit,
                 const std::string& title) {
  std::string ticks;
  for (const double tick : range.ticks) {
    ticks += fmt::format("{}{} {:.10g}", ticks.empty() ? "" : ", ",
                         gnuplot_string(quantity_words(tick, unit)), tick);
  }
  return fmt::format(
      "set logscale {0}\nset {0}range [{1:.10g}:{2:.10g}]\nset {0}tics ({3}) nomirror\n"
      "set {0}label {4} noenhanced\n",
      name, range.low, range.high, ticks, gnuplot_string(title));
}

std::string settings(const PictureData& data, const PictureFrame& frame) {
  return fmt::format(
             "set encoding utf8\n"
             "set terminal pngcairo size {:.0f},{:.0f} noenhanced font 'DejaVu Sans,12' "
             "background '#ffffff'\n"
             "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
             "set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n"
             "set border 3 lc rgb '{}'\nset grid lc rgb '#e2e3e0' lt 1 lw 1\nunset key\n",
             width, height, left / width, right / width, bottom / height, top / height,
             muted_colour) +
         axis('x', frame.seconds, "s", "time of all steps") +
         axis('y', frame.values, data.unit, data.label);
}

/// Below and left of the front there are no points: numbers go there, further out where the one
/// before would be covered.
std::string numbers(const PictureData& data, const PictureFrame& frame) {
  std::string script;
  std::vector<std::array<double, 2>> taken;
  for (const std::size_t index : numbered_front(data)) {
    double x = frame.x(data.points[index]) - 13, y = frame.y(data.points[index]) - 14;
    const auto covers = [&](const std::array<double, 2>& other) {
      return std::abs(other[0] - x) < 20 && std::abs(other[1] - y) < 17;
    };
    while (std::any_of(taken.begin(), taken.end(), covers)) {
      x -= 7;
      y -= 7;
    }
    taken.push_back({x, y});
    script += label_command(std::to_string(taken.size()), x, y, 12,
                            fmt::format("center tc rgb '{}' front", front_text_colour));
  }
  return script;
}

/// A block of rows: seconds, value, ends of the spread, gnuplot's symbol and colour.
std::string data_block(const std::string& name, const PictureData& data, const PictureFrame& frame,
                       const std::vector<std::size_t>& points) {
  const auto colours =
      colours_for(data.axes.empty() ? std::vector<std::string>{} : data.axes[0].values);
  std::string text = "$" + name + " << end_of_data\n";
  for (const std::size_t index : points) {
    const PicturePoint& point = data.points[index];
    const std::string colour =
        point.colour < 0 ? muted_colour : colours[static_cast<std::size_t>(point.colour)];
    text += fmt::format("{:.10g} {:.10g} {:.10g} {:.10g} {} 0x{}\n", point.seconds,
                        frame.shown_value(point), point.seconds_low, point.seconds_high,
                        symbol_for(point.symbol, point.converged), colour.substr(1));
  }
  return text + "end_of_data\n";
}

std::string plots(const PictureData& data, const PictureFrame& frame) {
  if (data.points.empty()) {
    return label_command("No variant has a place here.", left + 260, 480, 14) + "plot NaN\n";
  }
  std::vector<std::size_t> all, spread;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    all.push_back(i);
    if (data.points[i].seconds_low < data.points[i].seconds_high) spread.push_back(i);
  }
  std::string blocks, command;
  const auto draw = [&](const std::string& name, const std::vector<std::size_t>& points,
                        const std::string& how) {
    if (points.empty()) return;
    blocks += data_block(name, data, frame, points);
    command += fmt::format("{} ${} using {}", command.empty() ? "plot" : ",", name, how);
  };
  draw("front", data.front, fmt::format("1:2 with lines lw 2 lc rgb '{}'", front_colour));
  draw("spread", spread, "1:2:3:4 with xerrorbars pt 0 lw 1.2 lc rgb '#989ca4'");
  draw("points", all, "1:2:5:6 with points pt variable ps 1.7 lw 2 lc rgb variable");
  if (data.default_variant) {
    draw("default", {*data.default_variant}, "1:2 with points pt 6 ps 3.2 lw 2 lc rgb '#000000'");
  }
  return blocks + command + "\n";
}

}  // namespace

std::string picture_script(const Json& results) {
  const PictureData data = picture_data(results);
  const PictureFrame frame(data);
  return settings(data, frame) + words_around(data) + numbers(data, frame) + plots(data, frame);
}

}  // namespace ringlet
