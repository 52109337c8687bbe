// Twisting of a dihedral of four vertices: the torsion of the centreline (math.md, sections 1 and
// 3). With e0 = x0 - x1, e1 = x2 - x1, e2 = x3 - x2, and u, v the parts of e0, e2 normal to e1:
//
//     E = k/2 wrap(tau - tau0)^2,  k = GJ / l1,  tau = atan2(d . (u x v), u . v),  d = e1/|e1|
//
// tau has no value where an end edge is parallel to the middle one. There the element fades: E is
// multiplied by f(|u|/|e0|) f(|v|/|e2|), where f rises smoothly from 0 at 0 to 1 at the kernel's
// parameter `fade`. The force is that of the faded energy; the Hessian, with any filter, is that of
// E times f without the derivatives of f, whose curvature would hold a straightened strand
// straight. An element that lies in this range at rest is weaker by the same factor.

#include "core/batch_energy.h"
#include "energies/angle_filter.h"
#include "energies/dihedral.h"

namespace ringlet {

namespace {

/// f of one end, and its derivative with respect to the squared sine |u|^2 / |e0|^2.
template <class S>
struct Fade {
  S value, derivative;

  Fade(const S& squared_sine, double threshold) {
    const double scale = 1 / (threshold * threshold);
    const S s = min(scale * squared_sine, S(1));
    value = s * s * (S(3) - S(2) * s);
    derivative = S(6 * scale) * s * (S(1) - s);
  }
};

struct Twist {
  struct Parameters {
    double fade = 1e-4;

    static Schema<Parameters> schema() {
      return Schema<Parameters>().key(
          "fade", &Parameters::fade, "", Range{.low = 0, .high = 1, .low_excluded = true},
          "sine of the angle between an end edge and the middle edge of four vertices below which "
          "their twist, undefined where the edges are parallel, fades");
    }
  };
  static constexpr int vertices = 4;

  template <class S>
  struct Rest {
    S stiffness;         ///< k, J
    S angle;             ///< tau0, rad
    S shortest_squared;  ///< of an edge that has not collapsed, m^2
  };

  Parameters parameters;

  Rest<double> rest(const ElementRest<4>& element) const {
    const auto& [l0, l1, l2] = element.lengths;
    const double shortest_squared = collapsed_squared_length(std::min({l0, l1, l2}));
    const Dihedral<double> dihedral(element.positions, 1, shortest_squared);
    const double radius = 0.5 * (element.radii[1] + element.radii[2]);
    const double rigidity = element.material.shear() * circle_polar_moment(radius);
    // A dihedral that has no torsion at rest, but for rounding, has no stiffness.
    constexpr double rounding = 1e-12;
    const double factor = dihedral.stiffness * fade(dihedral);
    const double stiffness = factor > rounding ? factor * rigidity / l1 : 0;
    return {stiffness, dihedral.torsion, shortest_squared};
  }

  Rest<double> rest_of(double stiffness, double torsion) const {
    return {stiffness, torsion, collapsed_squared_length(0)};
  }

  /// As far as the torsion can be from that at rest before it wraps.
  Hold hold(const Stencil<double, 4>& x, double slope, Rest<double>& rest) const {
    constexpr double most = 3;
    const Dihedral<double> dihedral(x, rest.stiffness, rest.shortest_squared);
    if (dihedral.stiffness == 0 || fade(dihedral) < 1) return Hold::impossible;
    rest.angle = wrap_angle(dihedral.torsion - std::clamp(slope, -most, most));
    return std::abs(slope) <= most ? Hold::exact : Hold::without_rest;
  }

  template <class S>
  using Geometry = Dihedral<S>;
  template <class S>
  Dihedral<S> geometry(const Stencil<S, 4>& x, const Rest<S>& rest) const {
    return {x, rest.stiffness, rest.shortest_squared};
  }

  template <class S>
  S value(const Stencil<S, 4>& x, const Rest<S>& rest) const {
    const Dihedral<S> dihedral = geometry(x, rest);
    const S difference = wrap_angle(S(dihedral.torsion - rest.angle));
    const S energy = S(0.5) * dihedral.stiffness * difference * difference;
    return any(is_fading(dihedral)) ? energy * fade(dihedral) : energy;
  }

  template <class S>
  S evaluate(Dihedral<S> dihedral, const Rest<S>& rest, Filter filter,
             ElementOutputs<S, 4> outputs) const {
    const S g = wrap_angle(S(dihedral.torsion - rest.angle));
    const S energy = S(0.5) * dihedral.stiffness * g * g;
    S faded = 1;
    const bool fading = any(is_fading(dihedral));
    if (fading) {
      faded = fade(dihedral);
      dihedral.stiffness = dihedral.stiffness * faded;
    }
    if (filter == Filter::tight) differentiate<Filter::tight>(dihedral, g, outputs);
    if (filter == Filter::paper) differentiate<Filter::paper>(dihedral, g, outputs);
    if (filter == Filter::exact) differentiate<Filter::exact>(dihedral, g, outputs);
    if (filter == Filter::gauss_newton) {
      differentiate<Filter::gauss_newton>(dihedral, g, outputs);
    }
    if (fading) add_fade_gradient(dihedral, energy, outputs);
    return energy * faded;
  }

 private:
  template <class S>
  auto is_fading(const Dihedral<S>& dihedral) const {
    const double squared = parameters.fade * parameters.fade;
    return dihedral.uu < squared * dihedral.n0 || dihedral.vv < squared * dihedral.n2;
  }
  template <class S>
  Fade<S> first_fade(const Dihedral<S>& dihedral) const {
    return {dihedral.uu / dihedral.n0, parameters.fade};
  }
  template <class S>
  Fade<S> last_fade(const Dihedral<S>& dihedral) const {
    return {dihedral.vv / dihedral.n2, parameters.fade};
  }
  template <class S>
  S fade(const Dihedral<S>& dihedral) const {
    return first_fade(dihedral).value * last_fade(dihedral).value;
  }

  /// gradient += energy d(f0 f2)/dx. |u|^2/|e0|^2 has the derivatives 2 (u - (|u|^2/|e0|^2)
  /// e0)/|e0|^2 with respect to e0 and -2 a u/|e0|^2 with respect to e1.
  template <class S>
  void add_fade_gradient(const Dihedral<S>& dihedral, const S& energy,
                         ElementOutputs<S, 4> outputs) const {
    const Fade<S> first = first_fade(dihedral), last = last_fade(dihedral);
    const S inverse_n0 = S(1) / dihedral.n0, inverse_n2 = S(1) / dihedral.n2;
    const S weight0 = S(2) * energy * first.derivative * last.value * inverse_n0;
    const S weight2 = S(2) * energy * last.derivative * first.value * inverse_n2;
    const Vector3<S>& u = dihedral.u;
    const Vector3<S>& v = dihedral.v;
    const Vector3<S> by_e0 = weight0 * (u - (dihedral.uu * inverse_n0) * dihedral.e0);
    const Vector3<S> by_e2 = weight2 * (v - (dihedral.vv * inverse_n2) * dihedral.e2);
    const Vector3<S> by_e1 = -(weight0 * dihedral.a) * u - (weight2 * dihedral.c) * v;
    outputs.add_gradient(0, -by_e0);
    outputs.add_gradient(1, by_e1);
    outputs.add_gradient(2, by_e2);
  }

  template <Filter filter, class S>
  static void differentiate(const Dihedral<S>& dihedral, const S& g, ElementOutputs<S, 4> outputs) {
    const S& a = dihedral.a;
    const S& c = dihedral.c;
    const S inverse_u = inverse_sqrt(dihedral.uu), inverse_v = inverse_sqrt(dihedral.vv);
    const Vector3<S> u = (inverse_u * inverse_u) * dihedral.u;
    const Vector3<S> v = (inverse_v * inverse_v) * dihedral.v;
    const AnglePlane<S> plane{u, cross(u, dihedral.d), v, cross(v, dihedral.d)};
    // The first edge of the element is minus e0; what stands for u and v moves with e1, too.
    const S force = dihedral.stiffness * g;
    const Vector3<S> first = force * plane.b0, last = -force * plane.b1;
    outputs.add_gradient(0, -first);
    outputs.add_gradient(1, -(a * first + c * last));
    outputs.add_gradient(2, last);

    constexpr std::size_t half = filter == Filter::exact ? 4 : 2;
    std::array<RankOne<S, 4>, filter == Filter::gauss_newton ? 1 : 2 * half> terms;
    const auto set = [&](std::size_t i, const S& weight, const Vector3<S>& q0,
                         const Vector3<S>& q1) {
      terms[i].weight = weight;
      terms[i].q[0] = -q0;
      terms[i].q[1] = -(a * q0 + c * q1);
      terms[i].q[2] = q1;
    };
    if constexpr (filter == Filter::gauss_newton) {
      set(0, S(1), plane.b0, -plane.b1);
    } else {
      for_in_plane_terms<half>(plane, g, S(1), set);
      const std::span<RankOne<S, 4>, half> axial(terms.data() + half, half);
      if constexpr (filter == Filter::paper) {
        set_paper_axial_terms(dihedral, inverse_u, inverse_v, g, axial);
      } else {
        set_axial_terms(dihedral, inverse_u, inverse_v, g, axial);
      }
    }
    for (RankOne<S, 4>& term : terms) term.weight = dihedral.stiffness * term.weight;
    outputs.add_hessian(terms);
  }

  /// The part of the Hessian that moves u and v along e1. With s = +1 where cos tau >= 0 and -1
  /// elsewhere, the in-plane unit vectors f = unit(u/|u| + s v/|v|) and f' = d x f, and
  /// kappa(s) = (1, a, 0)/|u| + s (0, c, -1)/|v| over the edges, it is exactly
  ///
  ///     P(f, s,  g s sin(tau), g s sin(tau) / 2m) + P(f', -s, -g s sin(tau), g m)
  ///     P(f, s, p, q) = p/|e1|^2 F F^T - q/|e1| (F K^T + K F^T)
  ///     F = (0, f, 0),  K = kappa(s) x d (a vector along d an edge)
  ///
  /// where m = cos of half the angle between u and s v: it lies in [1/sqrt(2), 1], so that no term
  /// has a pole. Over the vertices, where an edge vector q stands for (-q, q), F and K are
  /// orthogonal: each P has one positive and one negative eigenvalue, those of a 2x2 matrix. First
  /// the positive parts; with four terms the negative ones behind them.
  template <class S, std::size_t N>
  static void set_axial_terms(const Dihedral<S>& dihedral, const S& inverse_u, const S& inverse_v,
                              const S& g, std::span<RankOne<S, 4>, N> terms) {
    const S& a = dihedral.a;
    const S& c = dihedral.c;
    const S& inverse_length = dihedral.inverse_length;
    const S s = copysign(S(1), dihedral.cosine);
    const S signed_inverse_v = s * inverse_v, scale = inverse_u * signed_inverse_v;
    const S cosine = dihedral.cosine * scale, sine = dihedral.sine * scale;
    const S squared_m = max(S(0.5) + S(0.5) * cosine, S(0.5));
    const S inverse_m = inverse_sqrt(squared_m), m = squared_m * inverse_m;
    const S half_inverse_m = S(0.5) * inverse_m;
    const Vector3<S> f = (half_inverse_m * inverse_u) * dihedral.u +
                         (half_inverse_m * signed_inverse_v) * dihedral.v;
    const S a_u = a * inverse_u, c_v = c * signed_inverse_v;

    const S g_per_length = g * inverse_length;
    const S h = g_per_length * sine * inverse_length;
    const auto set = [&](std::size_t i, const Vector3<S>& direction, double sign, const S& h_of_f,
                         const S& q) {
      const std::array<S, 3> kappa{inverse_u, a_u + sign * c_v, -sign * signed_inverse_v};
      const S at_1 = kappa[1] - kappa[0], at_2 = kappa[2] - kappa[1];
      const S doubled =
          S(2) * (kappa[0] * kappa[0] + at_1 * at_1 + at_2 * at_2 + kappa[2] * kappa[2]);
      const SplitPair<S> split = split_pair(S(q * q * doubled), h_of_f);
      const auto set_term = [&](RankOne<S, 4>& term, const S& weight, const S& along) {
        term.weight = S(0.5) * weight;
        for (int n = 0; n < 3; ++n) term.q[n] = (S(-2) * q * kappa[n]) * dihedral.d;
        term.q[1] += along * direction;
      };
      set_term(terms[i], split.weight, split.positive);
      if constexpr (N == 4) set_term(terms[2 + i], -split.weight, split.negative);
    };
    set(0, f, 1, h, g_per_length * sine * half_inverse_m);
    set(1, cross(dihedral.d, f), -1, -h, g_per_length * m);
  }

  /// The same part as the paper filters it (math.md, section 3): with the eigenvalues -g s tan and
  /// g s cot of half the angle between u and v, s the sign of tau, the positive one acts on
  /// K = (kappa_u +- kappa_v) d as if u and v did not depend on e1, minus the negative one on what
  /// that neglects, K - F. Both have a pole, where one of tan and cot has; kept finite.
  template <class S>
  static void set_paper_axial_terms(const Dihedral<S>& dihedral, const S& inverse_u,
                                    const S& inverse_v, const S& g,
                                    std::span<RankOne<S, 4>, 2> terms) {
    constexpr double pole = 1e-16;
    const S& a = dihedral.a;
    const S& c = dihedral.c;
    const S scale = inverse_u * inverse_v;
    const S cosine = dihedral.cosine * scale, sine = max(abs(dihedral.sine * scale), S(pole));
    const S small = sine / (S(1) + abs(cosine)), large = (S(1) + abs(cosine)) / sine;
    const auto acute = cosine > S(0);
    const auto tangent_is_negative = g * dihedral.sine > S(0);
    const auto set = [&](RankOne<S, 4>& term, double sign, const S& eigenvalue,
                         const auto& negative) {
      const S signed_v = sign * inverse_v;
      const Vector3<S> f =
          dihedral.inverse_length * (inverse_u * dihedral.u + signed_v * dihedral.v);
      const Vector3<S> neglected = select(negative, f, Vector3<S>{S(0), S(0), S(0)});
      term.weight = S(0.5) * abs(g) * eigenvalue;
      term.q[0] = inverse_u * dihedral.d;
      term.q[1] = (a * inverse_u + c * signed_v) * dihedral.d - neglected;
      term.q[2] = -signed_v * dihedral.d;
    };
    set(terms[0], 1, select(acute, small, large), tangent_is_negative);
    set(terms[1], -1, select(acute, large, small), !tangent_is_negative);
  }
};

}  // namespace

void register_twist(Registry& registry);
void register_twist(Registry& registry) {
  register_energy<Twist>(
      registry, "twist",
      {"resistance of four vertices to a change of their torsion angle",
       "k/2 wrap(tau - tau0)^2, k = GJ / l1", "math.md, section 3; Lifted Curls, SCA 2023"});
}

}  // namespace ringlet
