#pragma once

#include <map>
#include <string>

namespace ringlet {

/// The files of a folder of plugins/, which the program carries along: their texts by name.
std::map<std::string, std::string> bundled_project(const std::string& name);

}  // namespace ringlet
