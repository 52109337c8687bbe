#pragma once

#include <span>
#include <vector>

#include "core/contact_detector.h"

namespace ringlet {

/// Puts the lists that threads have found into one: sorted, every pair once.
void merge_sorted(std::span<const std::vector<EdgePair>> lists, std::vector<EdgePair>& pairs);

}  // namespace ringlet
