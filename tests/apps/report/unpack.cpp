#include "tests/apps/report/unpack.h"

#include <zlib.h>

#include <stdexcept>

namespace ringlet {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::runtime_error(what);
}

std::vector<std::uint8_t> from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const std::size_t digit = digits.find(c);
    require(digit != std::string::npos, "no base64");
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8) bytes.push_back(static_cast<std::uint8_t>((bits >> (count -= 8)) & 0xff));
  }
  return bytes;
}

/// The texts of the elements <script> that have a certain attribute.
std::vector<std::string> scripts(const std::string& html, const std::string& attribute) {
  std::vector<std::string> texts;
  const std::string tag = "<script " + attribute;
  for (std::size_t at = html.find(tag); at != std::string::npos; at = html.find(tag, at + 1)) {
    const std::size_t begin = html.find('>', at) + 1;
    texts.push_back(html.substr(begin, html.find("</script>", begin) - begin));
  }
  return texts;
}

int residual(const std::vector<std::uint8_t>& bytes, std::size_t low, std::size_t high) {
  const int zigzag = bytes.at(low) + 256 * bytes.at(high);
  return zigzag % 2 == 0 ? zigzag / 2 : -(zigzag + 1) / 2;
}

void append_frames(const std::vector<std::uint8_t>& bytes, const Json& record,
                   std::vector<std::vector<double>>& frames) {
  const std::vector<int> first = record["strands"]["first"];
  const auto vertices = static_cast<std::size_t>(first.back());
  require(!bytes.empty() && bytes.size() % (6 * vertices) == 0, "no whole frames");
  std::vector<int> steps(3 * vertices, 0);
  for (std::size_t at = 0; at < bytes.size(); at += 6 * vertices) {
    std::vector<double> frame(3 * vertices);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t strand = 0; strand + 1 < first.size(); ++strand) {
        int change = 0;
        for (auto v = static_cast<std::size_t>(first[strand]);
             v < static_cast<std::size_t>(first[strand + 1]); ++v) {
          const std::size_t low = at + axis * vertices + v;
          change += residual(bytes, low, low + 3 * vertices);
          int& step = steps[3 * v + axis];
          step = (step + change) & 0xffff;
          frame[3 * v + axis] = record["frames"]["low"][axis].get<double>() +
                                record["frames"]["step"][axis].get<double>() * step;
        }
      }
    }
    frames.push_back(std::move(frame));
  }
}

}  // namespace

std::vector<std::uint8_t> unpack_text(const std::string& text) {
  const std::vector<std::uint8_t> packed = from_base64(text);
  std::vector<std::uint8_t> bytes(64);
  while (true) {
    uLongf size = bytes.size();
    const int result = uncompress(bytes.data(), &size, packed.data(), packed.size());
    if (result == Z_OK) {
      bytes.resize(size);
      return bytes;
    }
    require(result == Z_BUF_ERROR && bytes.size() < 1u << 30, "not deflated");
    bytes.resize(2 * bytes.size());
  }
}

ReportContent read_report(const std::string& html) {
  const auto records = scripts(html, "id=\"record\"");
  require(records.size() == 1, "no record");
  ReportContent content{Json::parse(records[0]), {}, {}};
  for (const std::string& text : scripts(html, "class=\"frames\"")) {
    append_frames(unpack_text(text), content.record, content.frames);
  }
  const std::ptrdiff_t vertices = content.record["strands"]["first"].back();
  for (const std::string& text : scripts(html, "class=\"contacts\"")) {
    const std::vector<std::uint8_t> bytes = unpack_text(text);
    for (auto at = bytes.begin(); at != bytes.end(); at += vertices) {
      content.contacts.emplace_back(at, at + vertices);
    }
  }
  return content;
}

}  // namespace ringlet
