#include "tests/plugins/usda/read_usda.h"

#include <sstream>
#include <stdexcept>

namespace ringlet {
namespace {

class Lines {
 public:
  explicit Lines(const std::string& text) : text_(text) {
    if (text.empty() || text.back() != '\n') throw std::runtime_error("the last line is not ended");
  }

  void expect(const std::string& line) {
    if (const std::string found = take(); found != line) {
      throw std::runtime_error("expected '" + line + "', found '" + found + "'");
    }
  }
  /// What stands between two parts of a line; blanks at its end do not count.
  std::string between(const std::string& before, const std::string& after = "") {
    std::string line = take();
    line.erase(line.find_last_not_of(' ') + 1);
    if (!line.starts_with(before) || !line.ends_with(after) ||
        line.size() < before.size() + after.size()) {
      throw std::runtime_error("expected '" + before + "...' in '" + line + "'");
    }
    return line.substr(before.size(), line.size() - before.size() - after.size());
  }
  double number(const std::string& before) { return std::stod(between(before)); }

  std::string take() {
    std::string line;
    if (!std::getline(text_, line)) throw std::runtime_error("the file ends too early");
    return line;
  }
  bool at_end() { return text_.peek() == std::char_traits<char>::eof(); }

 private:
  std::istringstream text_;
};

/// Numbers with ", " between them.
template <class Number>
std::vector<Number> numbers(std::string text) {
  std::vector<Number> values;
  text += ", ";
  for (std::size_t end = 0; !text.empty(); text.erase(0, end + 2)) {
    end = text.find(", ");
    std::istringstream word(text.substr(0, end));
    Number value;
    if (!(word >> value) || !word.eof()) throw std::runtime_error("no number: " + word.str());
    values.push_back(value);
  }
  return values;
}

/// The coordinates of "(x, y, z), (x, y, z)".
std::vector<float> coordinates(std::string text) {
  if (!text.starts_with("(") || !text.ends_with(")"))
    throw std::runtime_error("no points: " + text);
  text = text.substr(1, text.size() - 2);
  std::vector<float> all;
  for (std::size_t end = 0; end != std::string::npos; text.erase(0, end + 4)) {
    end = text.find("), (");
    const std::vector<float> point = numbers<float>(text.substr(0, end));
    if (point.size() != 3) throw std::runtime_error("no point: " + text.substr(0, end));
    all.insert(all.end(), point.begin(), point.end());
    if (end == std::string::npos) break;
  }
  return all;
}

}  // namespace

UsdaContent read_usda(const std::string& text) {
  Lines lines(text);
  UsdaContent content;
  lines.expect("#usda 1.0");
  lines.expect("(");
  lines.expect("    defaultPrim = \"strands\"");
  lines.expect("    doc = \"strands of ringlet\"");
  content.end = lines.number("    endTimeCode = ");
  lines.expect("    metersPerUnit = 1");
  content.start = lines.number("    startTimeCode = ");
  content.time_codes_per_second = lines.number("    timeCodesPerSecond = ");
  for (const char* line :
       {"    upAxis = \"Y\"", ")", "", "def BasisCurves \"strands\"", "{",
        "    uniform token type = \"linear\"", "    uniform token wrap = \"nonperiodic\""}) {
    lines.expect(line);
  }
  content.vertex_counts = numbers<int>(lines.between("    int[] curveVertexCounts = [", "]"));
  content.widths = numbers<float>(lines.between("    float[] widths = [", "] ("));
  lines.expect("        interpolation = \"vertex\"");
  lines.expect("    )");
  lines.expect("    point3f[] points.timeSamples = {");
  for (std::string line; (line = lines.take()) != "    }";) {
    const std::size_t colon = line.find(": [");
    if (colon == std::string::npos || !line.starts_with("        ") || !line.ends_with("],")) {
      throw std::runtime_error("no sample: " + line);
    }
    content.time_codes.push_back(std::stod(line.substr(8, colon - 8)));
    content.points.push_back(coordinates(line.substr(colon + 3, line.size() - colon - 5)));
  }
  content.extent = coordinates(lines.between("    float3[] extent = [", "]"));
  lines.expect("}");
  if (!lines.at_end()) throw std::runtime_error("there is something after the end");
  return content;
}

}  // namespace ringlet
