#pragma once

#include <string>

namespace ringlet {

/// A number with three digits and its unit; m, s, J, N and B take a prefix: "120 µm", "1.5 s".
std::string quantity_words(double value, const std::string& unit);

}  // namespace ringlet
