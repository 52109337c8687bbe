#pragma once

#include <array>
#include <cstdint>

namespace ringlet {

/// What a sample needs numbers for; each name is the first of two dimensions.
enum SampleDimension : int { in_pixel = 0, on_light = 2, in_sky = 4, sample_dimensions = 6 };

/// Points of a sequence that fills the unit cube evenly, moved in each pixel by an amount of its
/// own: sample i is i times a vector, whose entries are powers of the inverse of the root of
/// x^7 = x + 1 (the R-sequence of M. Roberts, "The Unreasonable Effectiveness of Quasirandom
/// Sequences", 2018). Nothing depends on what is computed when or by which thread.
class SamplePattern {
 public:
  explicit SamplePattern(std::uint64_t pixel);
  /// In [0, 1).
  float operator()(int sample, int dimension) const;

 private:
  std::array<double, sample_dimensions> shift_;
};

}  // namespace ringlet
