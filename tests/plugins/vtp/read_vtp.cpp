#include "tests/plugins/vtp/read_vtp.h"

#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace ringlet {
namespace {

void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error("not well formed: " + what);
}

std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t begin = tag.find(" " + name + "=\"");
  if (begin == std::string::npos) return "";
  const std::size_t from = begin + name.size() + 3;
  return tag.substr(from, tag.find('"', from) - from);
}

// The part of a text between two marks, both of which must be there.
std::string between(const std::string& text, const std::string& begin, const std::string& end,
                    std::size_t from = 0) {
  const std::size_t first = text.find(begin, from);
  require(first != std::string::npos, begin);
  const std::size_t last = text.find(end, first + begin.size());
  require(last != std::string::npos, end);
  return text.substr(first + begin.size(), last - first - begin.size());
}

template <class T>
std::vector<double> values_at(const std::string& appended, std::size_t offset) {
  std::uint64_t bytes = 0;
  require(offset + sizeof(bytes) <= appended.size(), "an offset");
  std::memcpy(&bytes, &appended[offset], sizeof(bytes));
  require(bytes % sizeof(T) == 0 && offset + sizeof(bytes) + bytes <= appended.size(), "a size");
  std::vector<double> values;
  for (std::size_t i = 0; i < bytes; i += sizeof(T)) {
    T value;
    std::memcpy(&value, &appended[offset + sizeof(bytes) + i], sizeof(T));
    values.push_back(static_cast<double>(value));
  }
  return values;
}

std::vector<double> values_in(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> values;
  for (double value = 0; stream >> value;) values.push_back(value);
  return values;
}

}  // namespace

VtpContent read_vtp(const std::string& bytes) {
  const std::string head = bytes.substr(0, bytes.find("<AppendedData"));
  const std::string file = between(head, "<VTKFile", ">");
  require(attribute(file, "type") == "PolyData", "type");
  require(attribute(file, "byte_order") == "LittleEndian", "byte_order");
  require(attribute(file, "header_type") == "UInt64", "header_type");
  std::string appended;
  if (head.size() < bytes.size()) {
    const std::size_t begin = bytes.find('_', head.size()) + 1;
    appended = bytes.substr(begin, bytes.rfind("\n</AppendedData>") - begin);
  }

  VtpContent content;
  const std::string piece = between(head, "<Piece", ">");
  content.points = std::stoi(attribute(piece, "NumberOfPoints"));
  content.lines = std::stoi(attribute(piece, "NumberOfLines"));
  for (std::size_t at = head.find("<DataArray"); at != std::string::npos;
       at = head.find("<DataArray", at + 1)) {
    const std::string tag = between(head, "<DataArray", ">", at);
    const std::string name = attribute(tag, "Name"), type = attribute(tag, "type");
    if (attribute(tag, "format") == "ascii") {
      const std::size_t end_of_tag = head.find('>', at);
      content.arrays[name] = values_in(between(head, ">", "</DataArray>", end_of_tag));
    } else {
      const auto offset = std::stoul(attribute(tag, "offset"));
      content.arrays[name] = type == "Float32" ? values_at<float>(appended, offset)
                                               : values_at<std::int32_t>(appended, offset);
    }
  }
  content.time = content.arrays.at("TimeValue").at(0);
  content.arrays.erase("TimeValue");
  return content;
}

}  // namespace ringlet
