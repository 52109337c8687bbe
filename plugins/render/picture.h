#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace ringlet {

/// A picture in sRGB, its rows from top to bottom, each of red, green and blue from left to right.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;

  const std::uint8_t* pixel(int x, int y) const { return &bytes[3 * (y * std::size_t(width) + x)]; }
};

/// Throws Error if the file cannot be written; an older one is then as it was.
void write_png(const Picture& picture, const std::filesystem::path& path);

}  // namespace ringlet
