#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/readers/file_bytes.h"

namespace ringlet {

/// A kind of number in a .ply file.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

int size_of(PlyType type);  ///< bytes

struct PlyProperty {
  std::string name;
  PlyType type;
  bool is_list;
  PlyType count_type;  ///< of the length that stands before a list
};

struct PlyElement {
  std::string name;
  std::int64_t count;
  std::vector<PlyProperty> properties;

  /// Where a property stands among those of the element; -1: nowhere.
  int find(const std::string& property) const;
};

/// What a .ply file says about itself, and how it is laid out.
struct PlyHeader {
  bool is_ascii = false;
  std::vector<PlyElement> elements;
};

/// Takes the header off a file. Throws Error where it is none, or where the file is too short for
/// the elements that it announces.
PlyHeader take_ply_header(FileBytes& bytes);

}  // namespace ringlet
