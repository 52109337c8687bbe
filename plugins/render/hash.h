#pragma once

#include <cstdint>

namespace ringlet {

/// Mixes 64 bits so that each bit of the result depends on all of them (the finaliser of
/// SplitMix64: Steele, Lea and Flood, OOPSLA 2014).
inline std::uint64_t mix_bits(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

/// A number in [0, 1) that only depends on these numbers, and looks as if drawn by chance.
inline float hashed_uniform(std::uint64_t a, std::uint64_t b, std::uint64_t c = 0) {
  const std::uint64_t bits = mix_bits(mix_bits(mix_bits(a) + b) + c);
  return static_cast<float>(bits >> 40) * 0x1p-24F;
}

}  // namespace ringlet
