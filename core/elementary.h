#pragma once

#include "core/lanes.h"

namespace ringlet {

// As in core/lanes.h: kernels call these unqualified, and every scalar finds its own.
using std::cos;
using std::exp;
using std::log;
using std::pow;
using std::sin;
using std::tan;

inline Pack pow(const Pack& base, double exponent) {
  return std::experimental::pow(base, Pack(exponent));
}

}  // namespace ringlet
