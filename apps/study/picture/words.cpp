#include "apps/study/picture/words.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "apps/study/picture/layout.h"
#include "apps/study/picture/quantity_words.h"
#include "apps/study/picture/symbols.h"
#include "apps/study/picture/text.h"

namespace ringlet {
namespace {

using namespace layout;

constexpr std::size_t most_numbers = 12, most_entries = 8, longest_name = 50;

std::string in_colour(const std::string& alignment, const char* colour) {
  return alignment + " tc rgb '" + colour + "'";
}

/// Of `count` things at most `most`, evenly, with the first and the last.
std::vector<std::size_t> thinned(std::size_t count, std::size_t most) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < std::min(count, most); ++i) {
    kept.push_back(count <= most ? i : i * (count - 1) / (most - 1));
  }
  return kept;
}

std::string headline(const PictureData& data) {
  std::string script = label_command(shortened(data.study, 80), 30, height - 34, 20);
  double y = height - 64;
  for (const std::string& line : wrapped(data.about, 160, 2)) {
    script += label_command(line, 30, y, 12);
    y -= 19;
  }
  return script;
}

std::string named(const PictureData& data, std::size_t index, double y) {
  const PicturePoint& point = data.points[index];
  const std::string costs =
      quantity_words(point.seconds, "s") + ", " + quantity_words(point.value, data.unit);
  return label_command(shortened(point.name, longest_name), side + 30, y, 11) +
         label_command(costs, side + 30, y - 16, 11, in_colour("left", muted_colour));
}

/// Beside the plot: the default and the front in words.
std::string listing(const PictureData& data) {
  std::string script;
  double y = top - 6;
  if (data.default_variant) {
    script += mark_command(6, "#000000", 2.6, side + 8, y) +
              label_command("default", side + 30, y, 12) +
              named(data, *data.default_variant, y - 19);
    y -= 64;
  }
  if (data.front.empty()) return script;
  const std::string title = "Pareto front: nothing is both faster and better";
  script += label_command(title, side, y, 12, in_colour("left", front_text_colour));
  int number = 0;
  for (const std::size_t index : numbered_front(data)) {
    y -= number == 0 ? 24 : 36;
    script += label_command(std::to_string(++number), side + 8, y, 12,
                            in_colour("center", front_text_colour)) +
              named(data, index, y);
  }
  return script;
}

/// A line below the plot: values of an axis and how they are drawn.
std::string key_line(const PictureData& data, std::size_t which, double y) {
  if (which >= data.axes.size()) return "";
  const PictureAxis& axis = data.axes[which];
  const std::vector<std::string> colours = colours_for(axis.values);
  std::string script = label_command(shortened(axis.title, 26), left, y, 11);
  double x = left + 230;
  for (const std::size_t index : thinned(axis.values.size(), most_entries)) {
    const std::string text = shortened(axis.values[index], 18);
    const bool by_colour = which == 0;
    script += mark_command(symbol_for(by_colour ? 0 : static_cast<int>(index), true),
                           by_colour ? colours[index] : muted_colour, 1.5, x, y) +
              label_command(text, x + 14, y, 11);
    x += 44 + 7.2 * static_cast<double>(text.size());
  }
  return script;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all;
}

std::string notes(const PictureData& data) {
  std::string text;
  std::vector<std::string> zero;
  for (const PicturePoint& point : data.points) {
    if (point.value == 0) zero.push_back(point.name);
  }
  const bool hollow = std::any_of(data.points.begin(), data.points.end(),
                                  [](const PicturePoint& point) { return !point.converged; });
  if (hollow) text += "Hollow: not converged in some steps. ";
  if (!data.timing_note.empty()) text += data.timing_note + " ";
  if (!data.without_place.empty()) {
    text += fmt::format("Without a place ({}): {}. ", data.without_place.size(),
                        joined(data.without_place));
  }
  if (!zero.empty()) text += "On the lower edge, with zero: " + joined(zero) + ".";
  return text;
}

std::string footnotes(const PictureData& data) {
  std::string script;
  double y = 46;
  for (const std::string& line : wrapped(notes(data), 175, 3)) {
    script += label_command(line, 30, y, 11, in_colour("left", muted_colour));
    y -= 16;
  }
  return script;
}

}  // namespace

std::vector<std::size_t> numbered_front(const PictureData& data) {
  std::vector<std::size_t> points;
  for (const std::size_t i : thinned(data.front.size(), most_numbers)) {
    points.push_back(data.front[i]);
  }
  return points;
}

std::string words_around(const PictureData& data) {
  return headline(data) + listing(data) + key_line(data, 0, 96) + key_line(data, 1, 74) +
         footnotes(data);
}

}  // namespace ringlet
