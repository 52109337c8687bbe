#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "core/sum_of_squares.h"

namespace ringlet {

/// The operations that computed a number from N variables, with their derivatives: each keeps its
/// gradient with respect to the variables, and its first and second derivatives with respect to
/// its arguments. From these the Hessian H of one of them follows in one pass backwards, as a sum
/// of few terms, one of low rank for each operation that is not linear (edge pushing; Gower, Mello:
/// "A new framework for the computation of Hessians", Optimization Methods and Software 27, 2012):
///
///     H = sum over operations f(a, b) of w (f_aa grad a grad a^T + f_bb grad b grad b^T
///                                           + f_ab (grad a grad b^T + grad b grad a^T)),
///
/// w being the derivative of that number with respect to the operation. With
/// Curvature::positive each term is replaced by its positive semi-definite part (of the 2x2 matrix
/// of w f_aa, w f_ab, w f_bb, its arguments scaled to gradients of equal length): a majorant of H,
/// exact where w f'' is nowhere negative, and without an eigenvalue problem of the size of H.
/// Operations of vectors are treated as a whole, so that it turns with the variables, and functions
/// of one operation alone as one function.
template <class S, int N>
class Trace {
 public:
  using Gradient = std::array<S, N>;
  static constexpr int constant = -1;

  /// Arguments of an operation of two vectors; a component may be constant.
  struct Vectors {
    std::array<int, 3> a, b;
    Vector3<S> a_value, b_value;
  };

  Trace() = default;
  Trace(const Trace&) = delete;
  Trace& operator=(const Trace&) = delete;

  [[gnu::always_inline]] const Gradient& gradient(int n) {
    Node& node = at(n);
    if (!node.has_gradient) compute_gradient(node);
    return node.gradient;
  }

  // Each of these returns the number of a new operation.

  /// A coordinate of the sum of the first few 3-vectors of variables. Before all others.
  [[gnu::always_inline]] int coordinate_of_sum(int vectors, int coordinate) {
    add(Operation::variable, vectors, coordinate).has_gradient = false;
    variables_ = nodes_.size();
    return last();
  }
  [[gnu::always_inline]] int sum(int a, int b) {
    if (base(a) == base(b)) {
      return function_of_base(base(a), slope(a) + slope(b), curve(a) + curve(b));
    }
    Node& node = add(Operation::sum, a, b);
    const Gradient &ga = gradient(a), &gb = gradient(b);
    for (int i = 0; i < N; ++i) node.gradient[i] = ga[i] + gb[i];
    return last();
  }
  [[gnu::always_inline]] int difference(int a, int b) {
    if (base(a) == base(b)) {
      return function_of_base(base(a), slope(a) - slope(b), curve(a) - curve(b));
    }
    Node& node = add(Operation::difference, a, b);
    const Gradient &ga = gradient(a), &gb = gradient(b);
    for (int i = 0; i < N; ++i) node.gradient[i] = ga[i] - gb[i];
    return last();
  }
  [[gnu::always_inline]] int scaled(int a, const S& factor) {
    return function_of_base(base(a), factor * slope(a), factor * curve(a));
  }
  [[gnu::always_inline]] int function(int a, const S& first, const S& second) {
    if (base(a) == a) return function_of_base(a, first, second);
    const S slope_a = slope(a);
    return function_of_base(base(a), first * slope_a,
                            second * slope_a * slope_a + first * curve(a));
  }
  int function(int a, int b, const S& first_a, const S& first_b, const Second<S>& second) {
    if (a == constant) return function(b, first_b, second.bb);
    if (b == constant) return function(a, first_a, second.aa);
    if (base(a) == base(b)) {
      const S sa = slope(a), sb = slope(b);
      return function_of_base(base(a), first_a * sa + first_b * sb,
                              second.aa * sa * sa + S(2) * second.ab * sa * sb +
                                  second.bb * sb * sb + first_a * curve(a) + first_b * curve(b));
    }
    Node& node = add(Operation::function_of_two, a, b);
    node.first_a = first_a;
    node.first_b = first_b;
    node.second = second;
    const Gradient &ga = gradient(a), &gb = gradient(b);
    for (int i = 0; i < N; ++i) node.gradient[i] = first_a * ga[i] + first_b * gb[i];
    return last();
  }
  [[gnu::always_inline]] int product(int a, int b, const S& value_a, const S& value_b) {
    if (base(a) == base(b)) {
      const S slope_a = slope(a), slope_b = slope(b);
      return function_of_base(base(a), value_b * slope_a + value_a * slope_b,
                              value_b * curve(a) + value_a * curve(b) + S(2) * slope_a * slope_b);
    }
    Node& node = add(Operation::product, a, b);
    node.first_a = value_b;
    node.first_b = value_a;
    const Gradient &ga = gradient(a), &gb = gradient(b);
    for (int i = 0; i < N; ++i) node.gradient[i] = value_b * ga[i] + value_a * gb[i];
    return last();
  }
  /// condition ? a : b, either of which may be constant.
  template <class Condition>
  int choice(const Condition& condition, int a, int b) {
    Node& node = add(Operation::choice, a, b);
    node.first_a = select(condition, S(1), S(0));
    for (const int argument : {a, b}) {
      if (argument != constant) gradient(argument);
    }
    for (int i = 0; i < N; ++i) {
      node.gradient[i] = select(condition, gradient_or_zero(a, i), gradient_or_zero(b, i));
    }
    has_choices_ = true;
    hessian_.mind_unused();
    return last();
  }
  int dot(const Vectors& arguments) {
    Node& node = add(Operation::dot, keep(arguments), constant);
    node.gradient.fill(S(0));
    add_products(node, arguments.a, components(arguments.b_value));
    add_products(node, arguments.b, components(arguments.a_value));
    return last();
  }
  /// The first of three, the components.
  int cross(const Vectors& arguments) {
    const int index = keep(arguments);
    const auto a = components(arguments.a_value), b = components(arguments.b_value);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      Node& node = add(i == 0 ? Operation::cross : Operation::rest_of_vector, index, constant);
      node.gradient.fill(S(0));
      add_product(node, arguments.a[j], b[k]);
      add_product(node, arguments.b[k], a[j]);
      add_product(node, arguments.a[k], S(-b[j]));
      add_product(node, arguments.b[j], S(-a[k]));
    }
    return last() - 2;
  }

  /// A vector, the first of the two arguments, times a number; the first of three.
  int scaled_vector(int scale, const S& value, const Vectors& arguments) {
    const int index = keep(arguments);
    const auto a = components(arguments.a_value);
    for (int i = 0; i < 3; ++i) {
      Node& node = add(i == 0 ? Operation::scaled_vector : Operation::rest_of_vector, index, scale);
      node.first_a = value;
      node.gradient.fill(S(0));
      add_product(node, arguments.a[i], value);
      add_product(node, scale, a[i]);
    }
    return last() - 2;
  }

  /// The Hessian of an operation. Call once; it lives as long as the trace.
  template <Curvature curvature>
  const SumOfSquares<S, N>& hessian(int node) {
    pass(node, S(1));
    for (int n = node; n >= variables_; --n) go_back<curvature>(n);
    return hessian_;
  }

 private:
  enum class Operation {
    variable,
    sum,
    difference,
    function,
    product,
    function_of_two,
    choice,
    dot,
    cross,
    scaled_vector,
    rest_of_vector
  };
  struct Node {
    Operation operation;
    int a, b;           ///< arguments; of an operation of vectors a is their number
    bool is_used;       ///< for what comes later
    bool has_gradient;  ///< or not yet, of a variable or a function of one
    S adjoint;          ///< w
    S first_a, first_b;
    Second<S> second;
    Gradient gradient;
  };
  using Triple = std::array<S, 3>;
  template <std::size_t M>
  using Rows = typename SumOfSquares<S, N>::template Rows<M>;

  static Triple components(const Vector3<S>& v) { return {v.x, v.y, v.z}; }

  [[gnu::always_inline]] int last() const { return nodes_.size() - 1; }
  [[gnu::always_inline]] Node& at(int node) { return nodes_[node]; }
  [[gnu::always_inline]] const Node& at(int node) const { return nodes_[node]; }
  [[gnu::always_inline]] Node& add(Operation operation, int a, int b) {
    Node& node = nodes_.add();
    node.operation = operation;
    node.a = a;
    node.b = b;
    node.is_used = false;
    node.has_gradient = true;
    node.adjoint = S(0);
    return node;
  }
  void compute_gradient(Node& node) {
    node.has_gradient = true;
    if (node.operation == Operation::variable) {
      for (int i = 0; i < N; ++i) node.gradient[i] = S(i % 3 == node.b && i / 3 < node.a ? 1 : 0);
      return;
    }
    const Gradient& of_base = gradient(node.a);
    for (int i = 0; i < N; ++i) node.gradient[i] = node.first_a * of_base[i];
  }
  /// A function of one operation that is no such function itself. Functions of it, and of several
  /// of it, are again functions of it: they leave no trace but the last.
  [[gnu::always_inline]] int function_of_base(int of, const S& first, const S& second) {
    Node& node = add(Operation::function, of, constant);
    node.first_a = first;
    node.second.aa = second;
    node.has_gradient = false;
    return last();
  }
  [[gnu::always_inline]] bool is_of_one(int n) const {
    return at(n).operation == Operation::function;
  }
  [[gnu::always_inline]] int base(int n) const { return is_of_one(n) ? at(n).a : n; }
  /// The derivatives with respect to the base.
  [[gnu::always_inline]] S slope(int n) const { return is_of_one(n) ? at(n).first_a : S(1); }
  [[gnu::always_inline]] S curve(int n) const { return is_of_one(n) ? at(n).second.aa : S(0); }
  int keep(const Vectors& arguments) {
    vectors_.add() = arguments;
    return vectors_.size() - 1;
  }
  [[gnu::always_inline]] S gradient_or_zero(int node, int i) const {
    return node == constant ? S(0) : at(node).gradient[i];
  }
  [[gnu::always_inline]] void add_product(Node& node, int argument, const S& factor) {
    if (argument == constant) return;
    const Gradient& of_argument = gradient(argument);
    for (int i = 0; i < N; ++i) node.gradient[i] += factor * of_argument[i];
  }
  void add_products(Node& node, const std::array<int, 3>& arguments, const Triple& factors) {
    for (int c = 0; c < 3; ++c) add_product(node, arguments[c], factors[c]);
  }

  /// Where nothing depends on an argument, its derivative must not matter, even if it is infinite.
  [[gnu::always_inline]] S passed_on(const S& adjoint, const S& first) const {
    return has_choices_ ? select(adjoint == S(0), S(0), S(adjoint * first)) : S(adjoint * first);
  }
  [[gnu::always_inline]] void pass(int argument, const S& adjoint) {
    if (argument == constant) return;
    at(argument).adjoint += adjoint;
    at(argument).is_used = true;
  }

  template <Curvature curvature>
  void go_back(int n) {
    const Node& node = at(n);
    const S w = node.adjoint;
    switch (node.operation) {
      case Operation::variable:
      case Operation::rest_of_vector:
        return;
      case Operation::sum:
        pass(node.a, w);
        pass(node.b, w);
        return;
      case Operation::difference:
        pass(node.a, w);
        pass(node.b, -w);
        return;
      case Operation::function:
        if (!node.is_used) return;
        pass(node.a, passed_on(w, node.first_a));
        hessian_.template add<curvature>(passed_on(w, node.second.aa), gradient(node.a));
        return;
      case Operation::product:
        pass(node.a, passed_on(w, node.first_a));
        pass(node.b, passed_on(w, node.first_b));
        hessian_.template add_products<curvature>(w, Rows<1>{&at(node.a).gradient},
                                                  Rows<1>{&at(node.b).gradient});
        return;
      case Operation::function_of_two:
        pass(node.a, passed_on(w, node.first_a));
        pass(node.b, passed_on(w, node.first_b));
        hessian_.template add_form<curvature>(
            {passed_on(w, node.second.aa), passed_on(w, node.second.ab),
             passed_on(w, node.second.bb)},
            at(node.a).gradient, at(node.b).gradient);
        return;
      case Operation::choice:
        pass(node.a, select(node.first_a > S(0), w, S(0)));
        pass(node.b, select(node.first_a > S(0), S(0), w));
        return;
      case Operation::dot:
        go_back_over_dot<curvature>(w, vectors_[node.a]);
        return;
      case Operation::cross:
        go_back_over_cross<curvature>({w, at(n + 1).adjoint, at(n + 2).adjoint}, vectors_[node.a]);
        return;
      case Operation::scaled_vector:
        go_back_over_scaled_vector<curvature>(n);
        return;
    }
  }

  Rows<3> rows(const std::array<int, 3>& arguments) {
    Rows<3> rows;
    for (int c = 0; c < 3; ++c) {
      rows[c] = arguments[c] == constant ? &zero() : &at(arguments[c]).gradient;
    }
    return rows;
  }
  const Gradient& zero() {
    Gradient& zero = hessian_.make();
    zero.fill(S(0));
    return zero;
  }
  static auto is_zero(const Triple& w) { return w[0] == S(0) && w[1] == S(0) && w[2] == S(0); }
  static bool is_constant(const std::array<int, 3>& v) {
    return v[0] == constant && v[1] == constant && v[2] == constant;
  }
  template <Curvature curvature>
  void go_back_over_dot(const S& w, const Vectors& v) {
    const Triple a = components(v.a_value), b = components(v.b_value);
    for (int c = 0; c < 3; ++c) {
      pass(v.a[c], passed_on(w, b[c]));
      pass(v.b[c], passed_on(w, a[c]));
    }
    if (is_constant(v.a) || is_constant(v.b)) return;
    if (v.a != v.b) {
      hessian_.template add_products<curvature>(w, rows(v.a), rows(v.b));
      return;
    }
    for (const int node : v.a) {
      if (node != constant) hessian_.template add<curvature>(2.0 * w, at(node).gradient);
    }
  }
  /// With u, v and the direction of w orthonormal, w . (a x b) = |w| (a_u b_v - a_v b_u).
  template <Curvature curvature>
  void go_back_over_cross(const Triple& w, const Vectors& v) {
    const Vector3<S> adjoint{w[0], w[1], w[2]};
    const Triple to_a = components(ringlet::cross(v.b_value, adjoint));
    const Triple to_b = components(ringlet::cross(adjoint, v.a_value));
    const S squared_length = squared_norm(adjoint);
    for (int c = 0; c < 3; ++c) {
      pass(v.a[c], select(is_zero(w), S(0), to_a[c]));
      pass(v.b[c], select(is_zero(w), S(0), to_b[c]));
    }
    if (is_constant(v.a) || is_constant(v.b)) return;
    const S inverse = inverse_root_or_zero(squared_length);
    const Vector3<S> axis =
        select(inverse == S(0), Vector3<S>{S(1), S(0), S(0)}, inverse * adjoint);
    const Vector3<S> first = any_normal(axis), second = ringlet::cross(axis, first);
    const Rows<3> a = rows(v.a), b = rows(v.b);
    const Gradient a_first = along(a, first), a_second = along(a, -second);
    const Gradient b_first = along(b, first), b_second = along(b, second);
    hessian_.template add_products<curvature>(
        S(squared_length * inverse), Rows<2>{&a_first, &a_second}, Rows<2>{&b_second, &b_first});
  }
  /// w . (s a) has the second derivatives of s times the number w . a, w being fixed.
  template <Curvature curvature>
  void go_back_over_scaled_vector(int n) {
    const Node& node = at(n);
    const Vectors& v = vectors_[node.a];
    const Triple w{node.adjoint, at(n + 1).adjoint, at(n + 2).adjoint};
    const Triple a = components(v.a_value);
    Gradient& along_w = hessian_.make();
    along_w.fill(S(0));
    for (int c = 0; c < 3; ++c) {
      pass(v.a[c], passed_on(w[c], node.first_a));
      pass(node.b, passed_on(w[c], a[c]));
      if (v.a[c] == constant) continue;
      for (int i = 0; i < N; ++i) along_w[i] += passed_on(w[c], at(v.a[c]).gradient[i]);
    }
    hessian_.template add_products<curvature>(select(is_zero(w), S(0), S(1)),
                                              Rows<1>{&at(node.b).gradient}, Rows<1>{&along_w});
  }
  [[gnu::always_inline]] static Gradient along(const Rows<3>& rows, const Vector3<S>& direction) {
    Gradient sum;
    for (int i = 0; i < N; ++i) {
      sum[i] =
          direction.x * (*rows[0])[i] + direction.y * (*rows[1])[i] + direction.z * (*rows[2])[i];
    }
    return sum;
  }

  // Most kernels need no more than these, which are on the stack.
  Pages<Node, 64> nodes_;
  Pages<Vectors, 8> vectors_;
  SumOfSquares<S, N> hessian_;
  bool has_choices_ = false;
  int variables_ = 0;
};

}  // namespace ringlet
