#include "core/suggest.h"

#include <algorithm>

namespace ringlet {
namespace {

// The "optimal string alignment" form: a neighbouring transposition counts as one edit.
int edit_distance(const std::string& a, const std::string& b) {
  const int rows = static_cast<int>(a.size()), columns = static_cast<int>(b.size());
  std::vector<std::vector<int>> d(rows + 1, std::vector<int>(columns + 1));
  for (int i = 0; i <= rows; ++i) d[i][0] = i;
  for (int j = 0; j <= columns; ++j) d[0][j] = j;
  for (int i = 1; i <= rows; ++i) {
    for (int j = 1; j <= columns; ++j) {
      const int change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[rows][columns];
}

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates) {
  std::string best;
  int best_distance = std::min(3, (static_cast<int>(word.size()) + 1) / 2);
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(word, candidate);
    if (distance >= best_distance) continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string nearest = nearest_word(word, candidates);
  if (!nearest.empty()) return "did you mean '" + nearest + "'?";
  std::string text = "known are: ";
  for (const std::string& candidate : candidates) {
    text += (&candidate == &candidates.front() ? "" : ", ") + candidate;
  }
  return candidates.empty() ? "none are known" : text;
}

}  // namespace ringlet
