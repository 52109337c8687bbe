#pragma once

#include <numbers>

#include "core/lanes.h"

namespace ringlet {

using std::atan2;

/// The angle of (x, y) in (-pi, pi], in lanes, to about one unit in the last place; 0 at the
/// origin.
///
/// With lo <= hi the two magnitudes, atan(lo/hi) = atan(c) + atan((lo - c hi)/(hi + c lo)) for the
/// multiple c of 1/4 nearest to lo/hi. What remains is below 1/8, where eight terms of the
/// Taylor series reach double precision.
[[gnu::always_inline]] inline Pack atan2(const Pack& y, const Pack& x) {
  const Pack abs_x = abs(x), abs_y = abs(y);
  const Pack hi = max(abs_x, abs_y), lo = min(abs_x, abs_y);
  Pack c = 0, atan_c = 0;
  const auto raise = [&](double from, double value, double atan_value) {
    const Mask above = lo > from * hi;
    c = select(above, Pack(value), c);
    atan_c = select(above, Pack(atan_value), atan_c);
  };
  raise(0.125, 0.25, 0.24497866312686415417);
  raise(0.375, 0.50, 0.46364760900080611621);
  raise(0.625, 0.75, 0.64350110879328438680);
  raise(0.875, 1.00, std::numbers::pi / 4);

  const Pack denominator = hi + c * lo;
  const Pack z = (lo - c * hi) / select(denominator == 0, Pack(1), denominator);
  const Pack s = z * z;
  // In pairs (Estrin): kernels wait for this angle, and a chain of seven products is long.
  const Pack s2 = s * s;
  const Pack low = (s * (1.0 / 5) - 1.0 / 3) + s2 * (s * (1.0 / 9) - 1.0 / 7);
  const Pack high = (s * (1.0 / 13) - 1.0 / 11) - s2 * (1.0 / 15);
  const Pack series = low + s2 * s2 * high;
  Pack angle = atan_c + (z + z * s * series);

  angle = select(abs_y > abs_x, std::numbers::pi / 2 - angle, angle);
  angle = select(x < 0, std::numbers::pi - angle, angle);
  return copysign(angle, y);
}

/// The angle modulo 2 pi in [-pi, pi], for angles within (-3 pi, 3 pi).
template <class S>
S wrap_angle(const S& angle) {
  constexpr double pi = std::numbers::pi;
  S wrapped = select(angle > S(pi), S(angle - 2 * pi), angle);
  return select(wrapped < S(-pi), S(wrapped + 2 * pi), wrapped);
}

}  // namespace ringlet
