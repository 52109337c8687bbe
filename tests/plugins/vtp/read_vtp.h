#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ringlet {

/// What stands in a .vtp file, read independently of the writer, from VTK's description of the
/// format. Throws std::runtime_error where the file is not well formed.
struct VtpContent {
  int points = 0, lines = 0;
  double time = 0;
  std::map<std::string, std::vector<double>> arrays;  ///< by name, the time apart
};

VtpContent read_vtp(const std::string& bytes);

}  // namespace ringlet
