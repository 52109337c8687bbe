#include "core/strand_bands.h"

#include <algorithm>

namespace ringlet {

void add_band_product(const StrandBands& bands, int group, std::span<const Vector3<Pack>> x,
                      std::span<Vector3<Pack>> y) {
  const int first_row = bands.groups()[group].first_row;
  for (int i = 0; i < static_cast<int>(x.size()); ++i) {
    Vector3<Pack> sum = bands.block(first_row + i, 0) * x[i];
    for (int k = 1; k <= std::min(i, band_blocks - 1); ++k) {
      const Matrix3<Pack>& block = bands.block(first_row + i, k);
      sum += block * x[i - k];
      y[i - k] += transpose_multiply(block, x[i]);
    }
    y[i] += sum;
  }
}

}  // namespace ringlet
