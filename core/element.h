#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string_view>
#include <utility>

#include "core/edge_derivatives.h"
#include "core/elementary.h"
#include "core/strands.h"
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
  Material material;                  ///< in its middle
  const Strands& strands;
  std::array<int, K> vertices;  ///< their numbers; of an element of pads all 0

  /// The length of the strand that bends at an inner vertex: half of the edges that meet there, but
  /// for one that is held. So a clamp lies where its last edge ends, and rods converge with second
  /// order; with the held half they would be longer by it, and converge with first order.
  double bending_length(int vertex) const {
    const bool is_real = vertices[vertex] > 0;
    double length = 0, with_held = 0;
    for (const int edge : {vertex - 1, vertex}) {
      with_held += 0.5 * lengths[edge];
      if (!is_real || !strands.is_held_edge(vertices[edge])) length += 0.5 * lengths[edge];
    }
    return length > 0 ? length : with_held;
  }

  /// A parameter in the middle of the element: at its middle vertex, or between its two middle
  /// ones.
  double middle(const Varying& parameter) const {
    return 0.5 *
           (parameter.at(strands, vertices[(K - 1) / 2]) + parameter.at(strands, vertices[K / 2]));
  }
};

/// One vector for each edge e_n = x_{n+1} - x_n of an element of K vertices.
template <class S, int K>
using EdgeVectors = std::array<Vector3<S>, K - 1>;

/// The matrix weight q q^T over the edges of an element.
template <class S, int K>
struct RankOne {
  S weight;
  EdgeVectors<S, K> q;
};

/// Where one element adds its gradient and its Hessian with respect to its K - 1 edges. The Hessian
/// is kept as 3x3 blocks in the layout of EdgeBands: of the blocks on the diagonal the lower
/// triangle alone has a meaning. A view.
template <class S, int K>
class ElementOutputs {
 public:
  /// The gradient of the first edge, and the first block of its row of the bands.
  ElementOutputs(Vector3<S>* gradient, Matrix3<S>* blocks) : gradient_(gradient), blocks_(blocks) {}

  void add_gradient(int edge, const Vector3<S>& gradient) const { gradient_[edge] += gradient; }
  /// The block at edges (row, column), row >= column.
  Matrix3<S>& block(int row, int column) const {
    return blocks_[row * edge_band_blocks + row - column];
  }
  /// Hessian += sum over the terms of weight q q^T, an entry at a time so that nothing but the
  /// result is written.
  template <std::size_t N>
  void add_hessian(const std::array<RankOne<S, K>, N>& terms) const {
    [&]<int... rows>(std::integer_sequence<int, rows...>) { (add_row<rows>(terms), ...); }
    (std::make_integer_sequence<int, K - 1>());
  }

 private:
  // Rows and columns are constants: what is left of loops here costs more than the sums.
  template <int row, std::size_t N>
  [[gnu::always_inline]] void add_row(const std::array<RankOne<S, K>, N>& terms) const {
    std::array<Vector3<S>, N> scaled;
    for (std::size_t t = 0; t < N; ++t) scaled[t] = terms[t].weight * terms[t].q[row];
    [&]<int... columns>(std::integer_sequence<int, columns...>) {
      (add_block<row, columns>(scaled, terms), ...);
    }
    (std::make_integer_sequence<int, row + 1>());
  }
  template <int row, int column, std::size_t N>
  [[gnu::always_inline]] void add_block(const std::array<Vector3<S>, N>& scaled,
                                        const std::array<RankOne<S, K>, N>& terms) const {
    Matrix3<S>& target = block(row, column);
    const auto add_entry = [&](int m, S Vector3<S>::*i, S Vector3<S>::*j) {
      S sum = target.m[m];
      for (std::size_t t = 0; t < N; ++t) sum += scaled[t].*i * terms[t].q[column].*j;
      target.m[m] = sum;
    };
    using V = Vector3<S>;
    constexpr bool is_diagonal = row == column;
    add_entry(0, &V::x, &V::x);
    if constexpr (!is_diagonal) add_entry(1, &V::x, &V::y);
    if constexpr (!is_diagonal) add_entry(2, &V::x, &V::z);
    add_entry(3, &V::y, &V::x);
    add_entry(4, &V::y, &V::y);
    if constexpr (!is_diagonal) add_entry(5, &V::y, &V::z);
    add_entry(6, &V::z, &V::x);
    add_entry(7, &V::z, &V::y);
    add_entry(8, &V::z, &V::z);
  }

  Vector3<S>* gradient_;
  Matrix3<S>* blocks_;
};

/// Gradient and Hessian of one element by themselves, at first zero.
template <class S, int K>
struct Derivatives {
  EdgeVectors<S, K> gradient;
  std::array<Matrix3<S>, (K - 1) * edge_band_blocks> blocks;

  Derivatives() {
    gradient.fill({S(0), S(0), S(0)});
    blocks.fill(Matrix3<S>::zero());
  }
  ElementOutputs<S, K> outputs() { return {gradient.data(), blocks.data()}; }
  Matrix3<S>& block(int row, int column) { return outputs().block(row, column); }
  const Matrix3<S>& block(int row, int column) const {
    return blocks[row * edge_band_blocks + row - column];
  }
  void add_to(ElementOutputs<S, K> target) const {
    for (int row = 0; row < K - 1; ++row) {
      target.add_gradient(row, gradient[row]);
      for (int column = 0; column <= row; ++column) target.block(row, column) += block(row, column);
    }
  }
};

/// How an element's Hessian is made positive semi-definite (math.md, sections 2 and 3). At rest all
/// of them give the exact Hessian.
enum class Filter {
  tight,  ///< closed form, a majorant; of an energy that gives only its value: that of Trace
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

/// An energy of a few vertices that depends on their differences alone, written once for every
/// scalar S. `Rest<S>` holds nothing but scalars S, one of them named `stiffness`, to which the
/// energy is proportional; `value` returns the energy, J, finite for every finite position.
template <class Kernel>
concept ValueKernel = requires(const Kernel& kernel, const Stencil<double, Kernel::vertices>& x,
                               const typename Kernel::template Rest<double>& rest) {
  requires Kernel::vertices >= 2 && Kernel::vertices <= band_blocks;
  { rest.stiffness } -> std::convertible_to<double>;
  { kernel.value(x, rest) } -> std::same_as<double>;
};

/// An energy of one element of a strand: `rest` computes the rest data of one element of the rest
/// state.
template <class Kernel>
concept ElementKernel = ValueKernel<Kernel> &&
    requires(const Kernel& kernel, const ElementRest<Kernel::vertices>& element) {
  { kernel.rest(element) } -> std::same_as<typename Kernel::template Rest<double>>;
};

/// Of a time step, s.
struct StepTime {
  double end;  ///< when it ends
  double dt;   ///< its length
};

/// A kernel whose rest data changes from step to step (a rest shape that flows, an actuation):
/// `update` returns that of the coming step from the positions at its beginning, with stiffness >=
/// 0, and 0 where it was 0.
template <class Kernel>
concept UpdatedKernel = ValueKernel<Kernel> &&
    requires(const Kernel& kernel, const Stencil<double, Kernel::vertices>& x,
             const typename Kernel::template Rest<double>& rest, const StepTime& time) {
  { kernel.update(x, rest, time) } -> std::same_as<typename Kernel::template Rest<double>>;
};

/// A closed-form kernel in two parts: `geometry` computes what value and derivatives follow from, a
/// chain of operations that wait for each other. What belongs to several elements is computed
/// faster in turn.
template <class Kernel>
concept GeometricKernel = ValueKernel<Kernel> &&
    requires(const Kernel& kernel, const Stencil<double, Kernel::vertices>& x,
             const typename Kernel::template Rest<double>& rest, Filter filter,
             ElementOutputs<double, Kernel::vertices> outputs) {
  { kernel.geometry(x, rest) } -> std::same_as<typename Kernel::template Geometry<double>>;
  { kernel.evaluate(kernel.geometry(x, rest), rest, filter, outputs) } -> std::same_as<double>;
};

/// A kernel that also gives its derivatives in closed form: returns the value, and adds gradient
/// and Hessian as the filter asks. It is never asked for a numeric filter.
template <class Kernel>
concept ClosedFormKernel = GeometricKernel<Kernel> ||
    (ValueKernel<Kernel>&& requires(const Kernel& kernel,
                                    const Stencil<double, Kernel::vertices>& x,
                                    const typename Kernel::template Rest<double>& rest,
                                    Filter filter,
                                    ElementOutputs<double, Kernel::vertices> outputs) {
      { kernel.evaluate(x, rest, filter, outputs) } -> std::same_as<double>;
    });

/// Whether an element can be given a rest state with which it pulls as wanted where it is.
enum class Hold {
  impossible,    ///< its pull has no direction there
  without_rest,  ///< yes, but no shape has this rest state: the element would be at rest nowhere
  exact,
};

/// A kernel that can choose the rest state of an element at x: `hold` changes rest so that there
/// the energy, k psi of some measure, has the slope psi' = slope, or leaves it as it is where that
/// is impossible. So the gradient at x is proportional to slope.
template <class Kernel>
concept HoldingKernel = ElementKernel<Kernel> &&
    requires(const Kernel& kernel, const Stencil<double, Kernel::vertices>& x, double slope,
             typename Kernel::template Rest<double>& rest) {
  { kernel.hold(x, slope, rest) } -> std::same_as<Hold>;
};

/// A kernel whose rest state follows from a stiffness and one number, its measure at rest.
template <class Kernel>
concept MeasureKernel = ElementKernel<Kernel> && requires(const Kernel& kernel, double number) {
  { kernel.rest_of(number, number) } -> std::same_as<typename Kernel::template Rest<double>>;
};

}  // namespace ringlet
