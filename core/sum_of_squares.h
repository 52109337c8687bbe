#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "core/pages.h"
#include "core/vector3.h"

namespace ringlet {

/// What is wanted of a Hessian: all of it, or of each operation the positive semi-definite part.
enum class Curvature { exact, positive };

/// Second derivatives of a function of two numbers.
template <class S>
struct Second {
  S aa, ab, bb;
};

/// 1 / sqrt(a), and 0 of what is too small for that.
template <class S>
[[gnu::always_inline]] inline S inverse_root_or_zero(const S& a) {
  const auto vanishes = a < S(1e-280);
  return select(vanishes, S(0), S(inverse_sqrt(select(vanishes, S(1), a))));
}

/// A symmetric matrix over N variables as a sum of terms weight q q^T, or of the positive
/// semi-definite parts of such terms.
template <class S, int N>
class SumOfSquares {
 public:
  using Gradient = std::array<S, N>;
  template <std::size_t M>
  using Rows = std::array<const Gradient*, M>;

  /// Where a weight is 0, q may be anything, not a number included; costs a little.
  void mind_unused() { mind_unused_ = true; }
  /// A vector that stays where it is, for terms made of it. Not initialised.
  Gradient& make() { return made_.add(); }

  /// weight q q^T. q must stay where it is.
  template <Curvature curvature>
  [[gnu::always_inline]] void add(const S& weight, const Gradient& q) {
    const S used = curvature == Curvature::exact ? weight : S(max(weight, S(0)));
    if (any(used != S(0))) add_square(used, q);
  }
  /// w sum over c of (p_c q_c^T + q_c p_c^T), which is w/2 sum of (alpha p_c + q_c / alpha)^2 -
  /// (alpha p_c - q_c / alpha)^2, with both parts equally long. One of these two is its positive
  /// part.
  template <Curvature curvature, std::size_t M>
  void add_products(const S& w, const Rows<M>& p, const Rows<M>& q) {
    const S squared_p = squared(p), squared_q = squared(q);
    const S ratio = squared_q * inverse_root_or_zero(squared_p * squared_q);
    const S inverse = inverse_root_or_zero(ratio), of_p = ratio * inverse;
    const S of_q = curvature == Curvature::exact ? inverse : S(copysign(inverse, w));
    for (std::size_t c = 0; c < M; ++c) {
      Gradient& sum = make();
      for (int i = 0; i < N; ++i) sum[i] = of_p * (*p[c])[i] + of_q * (*q[c])[i];
      add<curvature>(S(0.5) * (curvature == Curvature::exact ? w : S(abs(w))), sum);
      if (curvature == Curvature::positive) continue;
      Gradient& difference = make();
      for (int i = 0; i < N; ++i) difference[i] = of_p * (*p[c])[i] - of_q * (*q[c])[i];
      add<curvature>(S(-0.5) * w, difference);
    }
  }

  /// aa a a^T + ab (a b^T + b a^T) + bb b b^T. The positive part is that of the 2x2 matrix, for
  /// vectors that are scaled to length 1.
  template <Curvature curvature>
  void add_form(const Second<S>& h, const Gradient& a, const Gradient& b) {
    if (curvature == Curvature::exact) {
      add<curvature>(h.aa, a);
      add<curvature>(h.bb, b);
      add_products<curvature>(h.ab, Rows<1>{&a}, Rows<1>{&b});
      return;
    }
    const S squared_a = squared(a), squared_b = squared(b);
    const S inverse_a = inverse_root_or_zero(squared_a),
            inverse_b = inverse_root_or_zero(squared_b);
    const S aa = h.aa * squared_a, bb = h.bb * squared_b;
    const S ab = h.ab * (squared_a * inverse_a) * (squared_b * inverse_b);
    const S middle = S(0.5) * (aa + bb), half = S(0.5) * (aa - bb);
    const S squared_radius = half * half + ab * ab;
    const S radius = squared_radius * inverse_root_or_zero(squared_radius);
    // (c, s) of the larger eigenvalue; the other one's is (-s, c).
    const S longer = radius + abs(half);
    const S inverse = inverse_root_or_zero(longer * longer + ab * ab);
    const auto first = half > S(0) || radius == S(0);
    const S c = select(radius == S(0), S(1), S(select(first, longer, ab) * inverse));
    const S s = select(radius == S(0), S(0), S(select(first, ab, longer) * inverse));
    Gradient &high = make(), &low = make();
    for (int i = 0; i < N; ++i) {
      const S of_a = inverse_a * a[i], of_b = inverse_b * b[i];
      high[i] = c * of_a + s * of_b;
      low[i] = c * of_b - s * of_a;
    }
    add<curvature>(middle + radius, high);
    add<curvature>(middle - radius, low);
  }

  /// Visits the 3x3 blocks: visit(row, column, block), row >= column; of a block on the diagonal
  /// the lower triangle alone.
  template <class Visit>
  void for_each_block(const Visit& visit) const {
    [&]<int... rows>(std::integer_sequence<int, rows...>) { (visit_row<rows>(visit), ...); }
    (std::make_integer_sequence<int, N / 3>());
  }

 private:
  struct Square {
    S weight;
    const Gradient* q;
  };
  [[gnu::always_inline]] void add_square(const S& weight, const Gradient& q) {
    Square& square = squares_.add();
    square.weight = weight;
    square.q = &q;
    if (!mind_unused_) return;
    Gradient& used = made_.add();
    for (int i = 0; i < N; ++i) used[i] = select(weight == S(0), S(0), q[i]);
    square.q = &used;
  }
  template <int row, class Visit>
  void visit_row(const Visit& visit) const {
    std::array<Matrix3<S>, row + 1> blocks;
    for (Matrix3<S>& block : blocks) block = Matrix3<S>::zero();
    for (int t = 0; t < squares_.size(); ++t) {
      const auto& [weight, q] = squares_[t];
      for (int i = 0; i < 3; ++i) {
        const S scaled = weight * (*q)[3 * row + i];
        for (int j = 0; j <= 3 * row + i; ++j) blocks[j / 3].m[3 * i + j % 3] += scaled * (*q)[j];
      }
    }
    for (int column = 0; column <= row; ++column) visit(row, column, blocks[column]);
  }

  [[gnu::always_inline]] static S squared(const Gradient& q) {
    S sum = q[0] * q[0];
    for (int i = 1; i < N; ++i) sum += q[i] * q[i];
    return sum;
  }

  template <std::size_t M>
  static S squared(const Rows<M>& rows) {
    S sum = squared(*rows[0]);
    for (std::size_t c = 1; c < M; ++c) sum += squared(*rows[c]);
    return sum;
  }

  // Most kernels need no more than these, which are on the stack.
  Pages<Square, 64> squares_;
  Pages<Gradient, 32> made_;
  bool mind_unused_ = false;
};

}  // namespace ringlet
