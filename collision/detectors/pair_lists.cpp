#include "collision/detectors/pair_lists.h"

#include <tbb/parallel_sort.h>

#include <algorithm>

#include "core/parallel.h"

namespace ringlet {

void merge_sorted(std::span<const std::vector<EdgePair>> lists, std::vector<EdgePair>& pairs) {
  pairs.clear();
  for (const auto& list : lists) pairs.insert(pairs.end(), list.begin(), list.end());
  tbb::parallel_sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace ringlet
