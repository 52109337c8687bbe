#pragma once

// Bending energies k Psi(theta) of a hinge, k = EI / lbar, for any law Psi of its angle, with the
// closed-form filter of math.md, section 2.

#include <algorithm>
#include <array>

#include "core/batch_energy.h"
#include "energies/hinge.h"

namespace ringlet {

/// A law Psi of the turning angle phi = pi - theta: `value`, and its first and second derivative
/// with respect to phi. `rest` is what a law keeps of the angle at rest, linear in its
/// first derivative, as m0 is in 1/2 (m(phi) - m0)^2.
template <class Law>
concept AngleLaw = requires(const TurningAngle<double>& turning, double rest) {
  { Law::rest(turning) } -> std::same_as<double>;
  { Law::value(turning, rest) } -> std::same_as<double>;
  { Law::first(turning, rest) } -> std::same_as<double>;
  { Law::second(turning, rest) } -> std::same_as<double>;
};

template <AngleLaw Law>
struct AngleBending {
  using Parameters = NoParameters;
  static constexpr int vertices = 3;

  template <class S>
  struct Rest {
    S stiffness;         ///< k, J
    S rest;              ///< what the law keeps of the angle at rest
    S shortest_squared;  ///< of an edge that has not collapsed, m^2
  };

  [[no_unique_address]] Parameters parameters;

  Rest<double> rest(const ElementRest<3>& element) const {
    const auto& [l0, l1] = element.lengths;
    const double shortest_squared = collapsed_squared_length(std::min(l0, l1));
    const Hinge<double> hinge(element.positions, 1, shortest_squared);
    TurningAngle<double> turning = hinge.turning();
    // Rounding must not take the transverse stiffness of a straight strand.
    constexpr double straight = 1e-9;
    if (turning.radians < straight) turning = {0, 0};
    // A hinge that has no angle at rest has no stiffness.
    const double length = hinge.stiffness > 0 ? element.bending_length(1) : 1;
    const double rigidity =
        element.material.youngs_modulus * circle_second_moment(element.radii[1]);
    return {hinge.stiffness * rigidity / length, Law::rest(turning), shortest_squared};
  }

  Rest<double> rest_of(double stiffness, double theta) const {
    return {stiffness, Law::rest(turning_angle(theta)), collapsed_squared_length(0)};
  }

  Hold hold(const Stencil<double, 3>& x, double slope, Rest<double>& rest) const {
    const Hinge<double> hinge(x, rest.stiffness, rest.shortest_squared);
    const TurningAngle<double> turning = hinge.turning();
    if (hinge.stiffness == 0 || turning.radians < least_turning) return Hold::impossible;
    const double here = Law::rest(turning), first_a_unit = Law::first(turning, here + 1);
    if (first_a_unit == 0) return Hold::impossible;
    rest.rest = here + slope / first_a_unit;
    const bool has_angle = rest.rest >= Law::rest(turning_angle(std::numbers::pi)) &&
                           rest.rest <= Law::rest(turning_angle(0));
    return has_angle ? Hold::exact : Hold::without_rest;
  }

  template <class S>
  using Geometry = Hinge<S>;
  template <class S>
  Hinge<S> geometry(const Stencil<S, 3>& x, const Rest<S>& rest) const {
    return {x, rest.stiffness, rest.shortest_squared};
  }

  template <class S>
  S value(const Stencil<S, 3>& x, const Rest<S>& rest) const {
    const Hinge<S> hinge = geometry(x, rest);
    return hinge.stiffness * Law::value(hinge.turning(), rest.rest);
  }

  template <class S>
  S evaluate(const Hinge<S>& hinge, const Rest<S>& rest, Filter filter,
             ElementOutputs<S, 3> outputs) const {
    switch (filter) {
      case Filter::exact:
        return evaluate<Filter::exact>(hinge, rest.rest, outputs);
      case Filter::gauss_newton:
        return evaluate<Filter::gauss_newton>(hinge, rest.rest, outputs);
      default:  // the paper's filter of bending is the tight one
        return evaluate<Filter::tight>(hinge, rest.rest, outputs);
    }
  }

 private:
  /// A hinge that is straighter has no plane to speak of, in which it could hold a load.
  static constexpr double least_turning = 1e-4;

  template <Filter filter, class S>
  static S evaluate(const Hinge<S>& hinge, const S& rest, ElementOutputs<S, 3> outputs) {
    const TurningAngle<S> turning = hinge.turning();
    const S g = -Law::first(turning, rest), h = Law::second(turning, rest);
    const Vector3<S> normal = hinge.normal();
    const S inverse = hinge.inverse_lengths * hinge.inverse_lengths;
    const Vector3<S> t0 = (hinge.n1 * inverse) * hinge.e0, t1 = (hinge.n0 * inverse) * hinge.e1;
    const AnglePlane<S> plane{t0, cross(t0, normal), t1, cross(t1, normal)};

    const S force = hinge.stiffness * g;
    outputs.add_gradient(0, -force * plane.b0);
    outputs.add_gradient(1, -force * plane.b1);
    constexpr std::size_t in_plane = filter == Filter::tight ? 2 : 4;
    constexpr std::size_t off_plane = in_plane / 2;
    std::array<RankOne<S, 3>, filter == Filter::gauss_newton ? 1 : in_plane + off_plane> terms;
    // The first edge of the element is minus that of the hinge.
    const auto set = [&](std::size_t i, const S& weight, const Vector3<S>& q0,
                         const Vector3<S>& q1) {
      terms[i].weight = hinge.stiffness * weight;
      terms[i].q[0] = -q0;
      terms[i].q[1] = q1;
    };
    if constexpr (filter == Filter::gauss_newton) {
      set(0, max(h, S(0)), plane.b0, -plane.b1);
    } else {
      for_in_plane_terms<in_plane>(plane, g, h, set);
      for_off_plane_terms<off_plane>(
          hinge, normal, inverse, g, h,
          [&](std::size_t i, const S& weight, const Vector3<S>& q0, const Vector3<S>& q1) {
            set(in_plane + i, weight, q0, q1);
          });
    }
    outputs.add_hessian(terms);
    return hinge.stiffness * Law::value(turning, rest);
  }

  /// The eigenpairs -g tan(theta/2) of (bh, bh) and g cot(theta/2) of (bh, -bh): the positive one,
  /// or both.
  template <std::size_t N, class S, class See>
  [[gnu::always_inline]] static void for_off_plane_terms(const Hinge<S>& hinge,
                                                         const Vector3<S>& normal, const S& inverse,
                                                         const S& g, const S& h, const See& see) {
    const auto acute = hinge.e0_dot_e1 > S(0);
    const S ratio_to_first = hinge.n0 * hinge.lengths * inverse;  // |e0| / |e1|
    const S weight = S(0.5) * hinge.n1 * inverse;
    if constexpr (N == 1) {
      const auto with_tangent = g < S(0);
      const auto small = with_tangent == acute;
      const S sum = hinge.lengths + abs(hinge.e0_dot_e1);
      const S numerator = select(small, hinge.b_norm, sum);
      const S denominator = select(small, sum, hinge.b_norm);
      // Where the ratio has no bound the eigenvalue of a law that is at rest there stays below 2h,
      // but folded hinges lose the digits of g.
      const S magnitude = abs(g);
      const S bound = max(S(2.0 * h), S(1e14 * magnitude));
      const S eigenvalue = min(S(magnitude * (numerator / denominator)), bound);
      const S second = select(with_tangent, ratio_to_first, -ratio_to_first);
      see(0, weight * eigenvalue, normal, second * normal);
    } else {
      // Truly unbounded at a straight hinge that is bent at rest; kept finite.
      constexpr double bound = 1e16;
      const S small = hinge.small_half_tangent(), large = hinge.large_half_tangent();
      const S with_tangent = max(-g * select(acute, small, large), S(-bound));
      const S with_cotangent = max(g * select(acute, large, small), S(-bound));
      see(0, weight * min(with_tangent, S(bound)), normal, ratio_to_first * normal);
      see(1, weight * min(with_cotangent, S(bound)), normal, -ratio_to_first * normal);
    }
  }
};

}  // namespace ringlet
