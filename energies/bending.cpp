// Bending of a hinge of three vertices (math.md, sections 1 and 2; Shi et al., "Lifted Curls",
// SCA 2023). Both edges leave the middle vertex, e0 = x0 - x1, e1 = x2 - x1, so that theta = pi is
// straight:
//
//     E = k/2 (theta - theta0)^2,  k = EI / lbar,  theta = atan2(|e0 x e1|, e0 . e1)
//
// The turning angle pi - theta stands for theta throughout: it keeps its digits near straight.

#include "core/batch_energy.h"
#include "energies/angle_filter.h"

namespace ringlet {

namespace {

/// Psi(theta) = (theta - theta0)^2 / 2, as a function of the turning angles.
struct QuadraticLaw {
  template <class S>
  static S value(const S& turning, const S& rest_turning) {
    const S difference = turning - rest_turning;
    return S(0.5) * difference * difference;
  }
  /// dPsi/dtheta.
  template <class S>
  static S first(const S& turning, const S& rest_turning) {
    return rest_turning - turning;
  }
  /// d2Psi/dtheta2.
  template <class S>
  static S second(const S&, const S&) {
    return S(1);
  }
};

/// The two edges of a hinge and the angle between them. Where an edge has collapsed, a benign hinge
/// without stiffness stands in for it.
template <class S>
struct Hinge {
  Vector3<S> e0, e1;
  S n0, n1;      ///< squared lengths
  S stiffness;   ///< 0 where the hinge has collapsed
  Vector3<S> b;  ///< e0 x e1
  S b_norm;      ///< never 0
  S e0_dot_e1;
  S turning;  ///< pi - theta

  Hinge(const Stencil<S, 3>& x, const S& given_stiffness, const S& shortest_squared)
      : e0(x[0] - x[1]),
        e1(x[2] - x[1]),
        n0(squared_norm(e0)),
        n1(squared_norm(e1)),
        stiffness(given_stiffness) {
    const auto collapsed = n0 <= shortest_squared || n1 <= shortest_squared;
    if (any(collapsed)) {
      e0 = select(collapsed, Vector3<S>{S(0), S(1), S(0)}, e0);
      e1 = select(collapsed, Vector3<S>{S(1), S(0), S(0)}, e1);
      n0 = select(collapsed, S(1), n0);
      n1 = select(collapsed, S(1), n1);
      stiffness = select(collapsed, S(0), stiffness);
    }
    b = cross(e0, e1);
    e0_dot_e1 = dot(e0, e1);
    // A perfectly straight hinge turns by a trifle, so that ratios of its small angles exist.
    const S b_squared = squared_norm(b), least = S(1e-200) * n0 * n1;
    b_norm = sqrt(max(b_squared, least));
    turning = atan2(b_norm, S(-e0_dot_e1));
  }

  /// The unit normal of the hinge; of a straight or folded one, any normal to its edges.
  Vector3<S> normal() const {
    constexpr double rounding = 1e-14;
    const Vector3<S> unit = S(S(1) / b_norm) * b;
    const auto flat = b_norm * b_norm <= rounding * rounding * (n0 * n1);
    return any(flat) ? select(flat, any_normal(e0), unit) : unit;
  }
};

struct Bending {
  using Parameters = NoParameters;
  using Law = QuadraticLaw;
  static constexpr int vertices = 3;

  template <class S>
  struct Rest {
    S stiffness;         ///< k, J
    S angle;             ///< theta0, rad
    S shortest_squared;  ///< of an edge that has not collapsed, m^2
  };

  [[no_unique_address]] Parameters parameters;

  Rest<double> rest(const ElementRest<3>& element) const {
    const auto& [l0, l1] = element.lengths;
    const double shortest_squared = collapsed_squared_length(std::min(l0, l1));
    const Hinge<double> hinge(element.positions, 1, shortest_squared);
    // Rounding must not take the transverse stiffness of a straight strand.
    constexpr double straight = 1e-9;
    const double turning = hinge.turning < straight ? 0 : hinge.turning;
    // A hinge that has no angle at rest has no stiffness.
    const double length = hinge.stiffness > 0 ? 0.5 * (l0 + l1) : 1;
    const double rigidity =
        element.material.youngs_modulus * circle_second_moment(element.radii[1]);
    return {hinge.stiffness * rigidity / length, std::numbers::pi - turning, shortest_squared};
  }

  template <class S>
  S value(const Stencil<S, 3>& x, const Rest<S>& rest) const {
    const Hinge<S> hinge(x, rest.stiffness, rest.shortest_squared);
    return hinge.stiffness * Law::value(hinge.turning, S(std::numbers::pi - rest.angle));
  }

  template <class S>
  S evaluate(const Stencil<S, 3>& x, const Rest<S>& rest, Filter filter,
             Derivatives<S, 3>& derivatives) const {
    const Hinge<S> hinge(x, rest.stiffness, rest.shortest_squared);
    return filter == Filter::tight ? evaluate<Filter::tight>(hinge, rest, derivatives)
                                   : evaluate<Filter::exact>(hinge, rest, derivatives);
  }

  template <Filter filter, class S>
  static S evaluate(const Hinge<S>& hinge, const Rest<S>& rest, Derivatives<S, 3>& derivatives) {
    const S rest_turning = std::numbers::pi - rest.angle;
    const S g = Law::first(hinge.turning, rest_turning);
    const S h = Law::second(hinge.turning, rest_turning);
    const Vector3<S> normal = hinge.normal();
    const S inverse = S(1) / (hinge.n0 * hinge.n1);
    const Vector3<S> t0 = (hinge.n1 * inverse) * hinge.e0, t1 = (hinge.n0 * inverse) * hinge.e1;
    const AnglePlane<S> plane{t0, cross(t0, normal), t1, cross(t1, normal)};

    const S force = hinge.stiffness * g;
    derivatives.gradient[0] = force * plane.b0;
    derivatives.gradient[2] = -force * plane.b1;
    derivatives.gradient[1] = -derivatives.gradient[0] - derivatives.gradient[2];

    constexpr std::size_t in_plane = filter == Filter::tight ? 2 : 4;
    constexpr std::size_t off_plane = filter == Filter::tight ? 1 : 2;
    std::array<RankOne<S, 3>, in_plane + off_plane> terms;
    const auto set = [&](std::size_t i, const PairTerm<S>& term) {
      terms[i].weight = hinge.stiffness * term.weight;
      terms[i].q[0] = term.q0;
      terms[i].q[1] = -term.q0 - term.q1;
      terms[i].q[2] = term.q1;
    };
    const auto in_plane_part = in_plane_terms<S, in_plane>(plane, g, h);
    for (std::size_t i = 0; i < in_plane; ++i) set(i, in_plane_part[i]);
    const auto off_plane_part = off_plane_terms<S, off_plane>(hinge, normal, inverse, g, h);
    for (std::size_t i = 0; i < off_plane; ++i) set(in_plane + i, off_plane_part[i]);
    derivatives.set_hessian(terms);
    return hinge.stiffness * Law::value(hinge.turning, rest_turning);
  }

  /// The eigenpairs -g tan(theta/2) of (bh, bh) and g cot(theta/2) of (bh, -bh): the positive one,
  /// or both.
  template <class S, std::size_t N>
  static std::array<PairTerm<S>, N> off_plane_terms(const Hinge<S>& hinge, const Vector3<S>& normal,
                                                    const S& inverse, const S& g, const S& h) {
    // With sine and cosine scaled by |e0||e1|: tan(theta/2) and its inverse are sine / (1 +
    // |cosine|), in which nothing cancels, or the inverse of that.
    const S lengths = sqrt(hinge.n0 * hinge.n1);
    const S sum = lengths + abs(hinge.e0_dot_e1);
    const auto acute = hinge.e0_dot_e1 > S(0);
    const S ratio_to_first = hinge.n0 * lengths * inverse;  // |e0| / |e1|
    const S weight = S(0.5) * hinge.n1 * inverse;
    std::array<PairTerm<S>, N> terms;
    if constexpr (N == 1) {
      const auto with_tangent = g < S(0);
      const auto small = with_tangent == acute;
      const S numerator = select(small, hinge.b_norm, sum);
      const S denominator = select(small, sum, hinge.b_norm);
      // Bounded by 2h in exact arithmetic; folded hinges lose the digits of g.
      const S eigenvalue = min(abs(g) * (numerator / denominator), 2.0 * h);
      const S second = select(with_tangent, ratio_to_first, -ratio_to_first);
      terms[0] = {weight * eigenvalue, normal, second * normal};
    } else {
      // Truly unbounded at a straight hinge that is bent at rest; kept finite.
      constexpr double bound = 1e16;
      const S small = hinge.b_norm / sum, large = sum / hinge.b_norm;
      const S with_tangent = max(-g * select(acute, small, large), S(-bound));
      const S with_cotangent = max(g * select(acute, large, small), S(-bound));
      terms[0] = {weight * min(with_tangent, S(bound)), normal, ratio_to_first * normal};
      terms[1] = {weight * min(with_cotangent, S(bound)), normal, -ratio_to_first * normal};
    }
    return terms;
  }
};

}  // namespace

void register_bending(Registry& registry);
void register_bending(Registry& registry) {
  register_energy<Bending>(
      registry, "bending",
      {"resistance of the hinges to a change of the angle between their edges",
       "k/2 (theta - theta0)^2, k = EI / lbar", "math.md, section 2; Lifted Curls, SCA 2023"});
}

}  // namespace ringlet
