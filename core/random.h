#pragma once

#include <cstdint>
#include <random>

namespace ringlet {

/// Random numbers that are the same on every platform: the standard specifies the bits of its
/// Mersenne twister, but not those of its distributions.
class Random {
 public:
  /// Equal seeds give equal numbers; different streams of one seed are unrelated.
  explicit Random(unsigned seed, unsigned stream = 0)
      : engine_((std::uint64_t{stream} << 32) | seed) {}

  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace ringlet
