#pragma once

#include "core/lanes.h"

namespace ringlet {

// As in core/lanes.h: kernels call these unqualified. In packs they are computed lane after lane by
// the standard library, exactly as for doubles.
using std::cos;
using std::exp;
using std::log;
using std::pow;
using std::sin;
using std::tan;

template <class Function>
Pack map_lanes(const Pack& values, const Function& function) {
  return Pack([&](int lane) { return function(static_cast<double>(values[lane])); });
}
inline Pack cos(const Pack& a) {
  return map_lanes(a, [](double x) { return std::cos(x); });
}
inline Pack exp(const Pack& a) {
  return map_lanes(a, [](double x) { return std::exp(x); });
}
inline Pack log(const Pack& a) {
  return map_lanes(a, [](double x) { return std::log(x); });
}
inline Pack sin(const Pack& a) {
  return map_lanes(a, [](double x) { return std::sin(x); });
}
inline Pack tan(const Pack& a) {
  return map_lanes(a, [](double x) { return std::tan(x); });
}
inline Pack pow(const Pack& base, double exponent) {
  return map_lanes(base, [&](double x) { return std::pow(x, exponent); });
}

}  // namespace ringlet
