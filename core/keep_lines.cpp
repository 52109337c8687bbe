#include "core/keep_lines.h"

#include <fstream>
#include <limits>
#include <string>

#include "core/error.h"

namespace ringlet {

void keep_lines(const std::filesystem::path& path, int count) {
  std::ifstream file(path, std::ios::binary);
  for (int line = 0; line < count; ++line) {
    if (file.ignore(std::numeric_limits<std::streamsize>::max(), '\n') && !file.eof()) continue;
    throw Error("'" + path.string() + "' has " + std::to_string(line) + " lines; expected " +
                std::to_string(count));
  }
  const auto length = file.tellg();
  file.close();
  std::filesystem::resize_file(path, static_cast<std::uintmax_t>(length));
}

}  // namespace ringlet
