#include "plugins/ply/ply_header.h"

#include <array>
#include <charconv>
#include <limits>
#include <sstream>

namespace ringlet {
namespace {

struct TypeName {
  const char* name;
  const char* other_name;
  PlyType type;
  int size;
};

constexpr std::array<TypeName, 8> types{{{"char", "int8", PlyType::int8, 1},
                                         {"uchar", "uint8", PlyType::uint8, 1},
                                         {"short", "int16", PlyType::int16, 2},
                                         {"ushort", "uint16", PlyType::uint16, 2},
                                         {"int", "int32", PlyType::int32, 4},
                                         {"uint", "uint32", PlyType::uint32, 4},
                                         {"float", "float32", PlyType::float32, 4},
                                         {"double", "float64", PlyType::float64, 8}}};

constexpr int longest_line = 1000;

std::vector<std::string> take_words(FileBytes& bytes) {
  std::string line;
  while (true) {
    const char letter = bytes.take<char>("header");
    if (letter == '\n') break;
    if (line.size() == longest_line) bytes.fail("expected lines of a header");
    line += letter;
  }
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

PlyType type_of(const std::string& name, const FileBytes& bytes) {
  for (const TypeName& type : types) {
    if (name == type.name || name == type.other_name) return type.type;
  }
  bytes.fail("expected a type of number, found '" + name + "'");
}

std::int64_t count_of(const std::string& word, const FileBytes& bytes) {
  std::int64_t count = -1;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (failure != std::errc() || end != word.data() + word.size() || count < 0 ||
      count > std::numeric_limits<int>::max()) {
    bytes.fail("expected a number of elements below 2^31, found '" + word + "'");
  }
  return count;
}

void take_format(const std::string& name, const FileBytes& bytes, PlyHeader& header) {
  header.is_ascii = name == "ascii";
  if (header.is_ascii || name == "binary_little_endian") return;
  bytes.fail("expected the format 'ascii' or 'binary_little_endian', found '" + name + "'");
}

void take_property(const std::vector<std::string>& words, const FileBytes& bytes,
                   PlyHeader& header) {
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (header.elements.empty() || (!is_list && words.size() != 3)) {
    bytes.fail("expected 'property TYPE NAME' of an element");
  }
  const PlyType type = type_of(words[is_list ? 3 : 1], bytes);
  const PlyType count_type = is_list ? type_of(words[2], bytes) : type;
  header.elements.back().properties.push_back({words.back(), type, is_list, count_type});
}

/// Every number takes its bytes, in a text at least a digit; lists may be empty.
void check_size(const PlyHeader& header, const FileBytes& bytes) {
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty() && element.count > 0) {
      bytes.fail("expected properties of the element '" + element.name + "'");
    }
    std::int64_t least = 0;
    for (const PlyProperty& property : element.properties) {
      least +=
          header.is_ascii ? 1 : size_of(property.is_list ? property.count_type : property.type);
    }
    bytes.require(static_cast<std::uint64_t>(least * element.count),
                  std::to_string(element.count) + " elements '" + element.name + "'");
  }
}

}  // namespace

int size_of(PlyType type) { return types[static_cast<std::size_t>(type)].size; }

int PlyElement::find(const std::string& property) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property && !properties[i].is_list) return static_cast<int>(i);
  }
  return -1;
}

PlyHeader take_ply_header(FileBytes& bytes) {
  if (take_words(bytes) != std::vector<std::string>{"ply"}) {
    bytes.fail("expected the first line 'ply'");
  }
  PlyHeader header;
  bool has_format = false;
  for (auto words = take_words(bytes); words != std::vector<std::string>{"end_header"};
       words = take_words(bytes)) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "format" && words.size() == 3) {
      take_format(words[1], bytes, header);
      has_format = true;
    } else if (words[0] == "element" && words.size() == 3) {
      header.elements.push_back({words[1], count_of(words[2], bytes), {}});
    } else if (words[0] == "property") {
      take_property(words, bytes, header);
    } else {
      bytes.fail("expected 'format', 'element', 'property', 'comment' or 'end_header', found '" +
                 words[0] + "'");
    }
  }
  if (!has_format) bytes.fail("expected a line 'format'");
  check_size(header, bytes);
  return header;
}

}  // namespace ringlet
