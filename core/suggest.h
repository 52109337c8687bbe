#pragma once

#include <string>
#include <vector>

namespace ringlet {

/// The candidate that a misspelt word most likely means, or "" if none is near: Damerau-Levenshtein
/// distance at most 2 and less than half of the word.
std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates);

/// "did you mean 'radius'?", or, if nothing is near, "known are: ...".
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace ringlet
