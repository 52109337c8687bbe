#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string_view>

#include "core/elementary.h"
#include "core/material.h"
#include "core/strand_bands.h"
#include "core/vector3.h"

namespace ringlet {

/// An element: a window of K consecutive vertices of a strand. Edge 2, hinge 3, dihedral 4.
template <class S, int K>
using Stencil = std::array<Vector3<S>, K>;

/// What a kernel sees of one element in its rest state, root side first.
template <int K>
struct ElementRest {
  Stencil<double, K> positions;       ///< m
  std::array<double, K - 1> lengths;  ///< of the edges, m
  std::array<double, K> radii;        ///< of the strand at the vertices, m
  const Material& material;
};

/// The matrix weight q q^T over the vertices of an element.
template <class S, int K>
struct RankOne {
  S weight;
  Stencil<S, K> q;
};

/// Where one element adds its gradient and its Hessian with respect to its K vertices. Of the
/// Hessian the lower triangle is kept, as 3x3 blocks in the layout of the strand bands. A view.
template <class S, int K>
class ElementOutputs {
 public:
  /// The gradient of the first vertex, and the first block of its row of the bands.
  ElementOutputs(Vector3<S>* gradient, Matrix3<S>* blocks) : gradient_(gradient), blocks_(blocks) {}

  void add_gradient(int vertex, const Vector3<S>& gradient) const { gradient_[vertex] += gradient; }
  /// The block at vertices (row, column), row >= column.
  Matrix3<S>& block(int row, int column) const { return blocks_[row * band_blocks + row - column]; }
  /// Hessian += sum over the terms of weight q q^T, an entry at a time so that nothing but the
  /// result is written.
  template <std::size_t N>
  void add_hessian(const std::array<RankOne<S, K>, N>& terms) const {
    using V = Vector3<S>;
    for (int row = 0; row < K; ++row) {
      std::array<V, N> scaled;
      for (std::size_t t = 0; t < N; ++t) scaled[t] = terms[t].weight * terms[t].q[row];
      const auto entry = [&](S V::*i, S V::*j, int column) {
        S sum = scaled[0].*i * terms[0].q[column].*j;
        for (std::size_t t = 1; t < N; ++t) sum += scaled[t].*i * terms[t].q[column].*j;
        return sum;
      };
      for (int column = 0; column < row; ++column) {
        Matrix3<S>& target = block(row, column);
        target.m[0] += entry(&V::x, &V::x, column);
        target.m[1] += entry(&V::x, &V::y, column);
        target.m[2] += entry(&V::x, &V::z, column);
        target.m[3] += entry(&V::y, &V::x, column);
        target.m[4] += entry(&V::y, &V::y, column);
        target.m[5] += entry(&V::y, &V::z, column);
        target.m[6] += entry(&V::z, &V::x, column);
        target.m[7] += entry(&V::z, &V::y, column);
        target.m[8] += entry(&V::z, &V::z, column);
      }
      Matrix3<S>& target = block(row, row);
      target.m[0] += entry(&V::x, &V::x, row);
      target.m[4] += entry(&V::y, &V::y, row);
      target.m[8] += entry(&V::z, &V::z, row);
      const S yx = entry(&V::y, &V::x, row), zx = entry(&V::z, &V::x, row);
      const S zy = entry(&V::z, &V::y, row);
      target.m[1] += yx;
      target.m[3] += yx;
      target.m[2] += zx;
      target.m[6] += zx;
      target.m[5] += zy;
      target.m[7] += zy;
    }
  }

 private:
  Vector3<S>* gradient_;
  Matrix3<S>* blocks_;
};

/// Gradient and Hessian of one element by themselves, at first zero.
template <class S, int K>
struct Derivatives {
  std::array<Vector3<S>, K> gradient;
  std::array<Matrix3<S>, K * band_blocks> blocks;

  Derivatives() {
    gradient.fill({S(0), S(0), S(0)});
    blocks.fill(Matrix3<S>::zero());
  }
  ElementOutputs<S, K> outputs() { return {gradient.data(), blocks.data()}; }
  Matrix3<S>& block(int row, int column) { return outputs().block(row, column); }
  const Matrix3<S>& block(int row, int column) const {
    return blocks[row * band_blocks + row - column];
  }
  void add_to(ElementOutputs<S, K> target) const {
    for (int row = 0; row < K; ++row) {
      target.add_gradient(row, gradient[row]);
      for (int column = 0; column <= row; ++column) target.block(row, column) += block(row, column);
    }
  }
};

/// How an element's Hessian is made positive semi-definite (math.md, sections 2 and 3). At rest all
/// of them give the exact Hessian.
enum class Filter {
  tight,  ///< closed form, a majorant; of an energy that gives only its value: clamp
  paper,  ///< the closed form of "Lifted Curls", a majorant, stiffer where twist is concerned
  exact,  ///< none: the exact Hessian, possibly indefinite
  gauss_newton,  ///< closed form, no majorant: Psi'' grad grad^T of the measure, where Psi'' > 0
  clamp,         ///< numeric: negative eigenvalues of the exact Hessian become 0
  absolute,      ///< numeric: negative eigenvalues of the exact Hessian change their sign
};

/// What remains to be done by a numeric eigensolver.
constexpr bool is_numeric(Filter filter) {
  return filter == Filter::clamp || filter == Filter::absolute;
}

/// An energy of one element, written once for every scalar S. `Rest<S>` holds nothing but scalars
/// S, one of them named `stiffness`, to which the energy is proportional. `rest` computes it for
/// one element of the rest state; `value` returns the energy, J, finite for every finite position.
template <class Kernel>
concept ElementKernel = requires(const Kernel& kernel, const Stencil<double, Kernel::vertices>& x,
                                 const ElementRest<Kernel::vertices>& element,
                                 const typename Kernel::template Rest<double>& rest) {
  requires Kernel::vertices >= 2 && Kernel::vertices <= band_blocks;
  { rest.stiffness } -> std::convertible_to<double>;
  { kernel.rest(element) } -> std::same_as<typename Kernel::template Rest<double>>;
  { kernel.value(x, rest) } -> std::same_as<double>;
};

/// A kernel that also gives its derivatives in closed form: returns the value, and adds gradient
/// and Hessian as the filter asks. It is never asked for a numeric filter.
template <class Kernel>
concept ClosedFormKernel = ElementKernel<Kernel> &&
    requires(const Kernel& kernel, const Stencil<double, Kernel::vertices>& x,
             const typename Kernel::template Rest<double>& rest, Filter filter,
             ElementOutputs<double, Kernel::vertices> outputs) {
  { kernel.evaluate(x, rest, filter, outputs) } -> std::same_as<double>;
};

/// A kernel whose rest state follows from a stiffness and one number, its measure at rest.
template <class Kernel>
concept MeasureKernel = ElementKernel<Kernel> && requires(const Kernel& kernel, double number) {
  { kernel.rest_of(number, number) } -> std::same_as<typename Kernel::template Rest<double>>;
};

}  // namespace ringlet
