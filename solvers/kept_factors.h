#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <mutex>
#include <vector>

#include "core/bytes.h"
#include "core/huge_pages.h"
#include "solvers/band_cholesky.h"

namespace ringlet {

/// The factors of the groups that are coupled, kept for the iterations of a solver that
/// preconditions with them. An iteration does little else than read them, so they are rounded to
/// single precision: half of the memory, and of the time. A rounded factor L is still one of a
/// positive definite matrix L L^T; what it changes is measured as it is made, and the factor of a
/// group that it would change by too much is kept as it is.
class KeptFactors {
 public:
  /// tolerance: of the solver; 0: nothing is rounded. The groups must outlive the factors.
  void bind(const StrandGroups& groups, double tolerance);

  /// Keeps a factor that factor_rows() made, solving B x = b. Thread-safe for different
  /// groups.
  void keep(int group, GroupBands factor, std::span<const Vector3<Pack>> b,
            std::span<const Vector3<Pack>> x);
  /// x = B^-1 x with the factor that was kept last. Where x is zero before row `first` of the
  /// group, it is left undefined there.
  void solve(int group, int first, std::span<Vector3<Pack>> x) const;

  std::size_t bytes() const;

 private:
  template <class Stored>
  using Rows = StreamedVector<FactorRow<Stored>>;

  std::span<FactorRow<SinglePack>> rounded(int group);
  bool is_close(std::span<const FactorRow<SinglePack>> factor, std::span<const Vector3<Pack>> b,
                std::span<const Vector3<Pack>> x);

  const StrandGroups* groups_ = nullptr;
  double largest_change_ = 0;
  std::once_flag has_rounded_;
  Rows<SinglePack> rounded_;       ///< of all groups
  std::vector<Rows<Pack>> exact_;  ///< of each group; empty: it is rounded
  tbb::enumerable_thread_specific<std::vector<Vector3<Pack>>> temporary_;
};

}  // namespace ringlet
