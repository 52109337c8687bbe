// Twisting of a dihedral of four vertices: the torsion of the centreline (math.md, sections 1 and
// 3). With e0 = x0 - x1, e1 = x2 - x1, e2 = x3 - x2, and u, v the parts of e0, e2 normal to e1:
//
//     E = k/2 wrap(tau - tau0)^2,  k = GJ / l1,  tau = atan2(d . (u x v), u . v),  d = e1/|e1|
//
// tau has no value where an end edge is parallel to the middle one. There the element fades: E is
// multiplied by f(|u|/|e0|) f(|v|/|e2|), where f rises smoothly from 0 at 0 to 1 at the kernel's
// parameter `fade`. The force is that of the faded energy; the Hessian is that of E times f,
// without the derivatives of f. An element that lies in this range at rest is weaker by the same
// factor.

#include "core/batch_energy.h"
#include "energies/angle_filter.h"

namespace ringlet {

namespace {

/// The edges of a dihedral, their parts normal to the middle one, and its torsion. Where an edge
/// has collapsed, a benign dihedral without stiffness stands in for it.
template <class S>
struct Dihedral {
  Vector3<S> e0, e1, e2;
  S n0, n1, n2;  ///< squared lengths
  S stiffness;   ///< 0 where the dihedral has collapsed
  S inverse_length;
  Vector3<S> d;     ///< e1 / |e1|
  S a, c;           ///< e0 = u + a e1, e2 = v + c e1
  Vector3<S> u, v;  ///< normal to e1
  S uu, vv;         ///< squared lengths, never 0
  S sine, cosine;   ///< of tau, times |u||v|
  S torsion;        ///< tau

  Dihedral(const Stencil<S, 4>& x, const S& given_stiffness, const S& shortest_squared)
      : e0(x[0] - x[1]),
        e1(x[2] - x[1]),
        e2(x[3] - x[2]),
        n0(squared_norm(e0)),
        n1(squared_norm(e1)),
        n2(squared_norm(e2)),
        stiffness(given_stiffness) {
    const auto collapsed =
        n0 <= shortest_squared || n1 <= shortest_squared || n2 <= shortest_squared;
    if (any(collapsed)) {
      e0 = select(collapsed, Vector3<S>{S(0), S(1), S(0)}, e0);
      e1 = select(collapsed, Vector3<S>{S(1), S(0), S(0)}, e1);
      e2 = select(collapsed, Vector3<S>{S(0), S(0), S(1)}, e2);
      n0 = select(collapsed, S(1), n0);
      n1 = select(collapsed, S(1), n1);
      n2 = select(collapsed, S(1), n2);
      stiffness = select(collapsed, S(0), stiffness);
    }
    inverse_length = S(1) / sqrt(n1);
    d = inverse_length * e1;
    a = dot(e0, d) * inverse_length;
    c = dot(e2, d) * inverse_length;
    u = e0 - a * e1;
    v = e2 - c * e1;
    // Rounding is all that is left of u below this; its square must have an inverse.
    constexpr double rounding = 1e-16;
    uu = max(squared_norm(u), S(rounding * rounding) * n0);
    vv = max(squared_norm(v), S(rounding * rounding) * n2);
    sine = dot(d, cross(u, v));
    cosine = dot(u, v);
    torsion = atan2(sine, cosine);
  }
};

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
    // A dihedral that has no torsion at rest has no stiffness.
    const double length = dihedral.stiffness > 0 ? l1 : 1;
    return {dihedral.stiffness * fade(dihedral) * rigidity / length, dihedral.torsion,
            shortest_squared};
  }

  template <class S>
  S value(const Stencil<S, 4>& x, const Rest<S>& rest) const {
    const Dihedral<S> dihedral(x, rest.stiffness, rest.shortest_squared);
    const S difference = wrap_angle(S(dihedral.torsion - rest.angle));
    const S energy = S(0.5) * dihedral.stiffness * difference * difference;
    return any(is_fading(dihedral)) ? energy * fade(dihedral) : energy;
  }

  template <class S>
  S evaluate(const Stencil<S, 4>& x, const Rest<S>& rest, Filter filter,
             Derivatives<S, 4>& derivatives) const {
    Dihedral<S> dihedral(x, rest.stiffness, rest.shortest_squared);
    const S g = wrap_angle(S(dihedral.torsion - rest.angle));
    const S energy = S(0.5) * dihedral.stiffness * g * g;
    S faded = 1;
    const bool fading = any(is_fading(dihedral));
    if (fading) {
      faded = fade(dihedral);
      dihedral.stiffness = dihedral.stiffness * faded;
    }
    if (filter == Filter::tight) {
      differentiate<Filter::tight>(dihedral, g, derivatives);
    } else {
      differentiate<Filter::exact>(dihedral, g, derivatives);
    }
    if (fading) add_fade_gradient(dihedral, energy, derivatives);
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
                         Derivatives<S, 4>& derivatives) const {
    const Fade<S> first = first_fade(dihedral), last = last_fade(dihedral);
    const S inverse_n0 = S(1) / dihedral.n0, inverse_n2 = S(1) / dihedral.n2;
    const S weight0 = S(2) * energy * first.derivative * last.value * inverse_n0;
    const S weight2 = S(2) * energy * last.derivative * first.value * inverse_n2;
    const Vector3<S>& u = dihedral.u;
    const Vector3<S>& v = dihedral.v;
    const Vector3<S> by_e0 = weight0 * (u - (dihedral.uu * inverse_n0) * dihedral.e0);
    const Vector3<S> by_e2 = weight2 * (v - (dihedral.vv * inverse_n2) * dihedral.e2);
    const Vector3<S> by_e1 = -(weight0 * dihedral.a) * u - (weight2 * dihedral.c) * v;
    derivatives.gradient[0] += by_e0;
    derivatives.gradient[1] -= by_e0 + by_e1;
    derivatives.gradient[2] += by_e1 - by_e2;
    derivatives.gradient[3] += by_e2;
  }

  template <Filter filter, class S>
  static void differentiate(const Dihedral<S>& dihedral, const S& g,
                            Derivatives<S, 4>& derivatives) {
    const S& a = dihedral.a;
    const S& c = dihedral.c;
    const S inverse = S(1) / (dihedral.uu * dihedral.vv);
    const S inverse_uu = dihedral.vv * inverse, inverse_vv = dihedral.uu * inverse;
    const Vector3<S> u = inverse_uu * dihedral.u, v = inverse_vv * dihedral.v;
    const AnglePlane<S> plane{u, cross(u, dihedral.d), v, cross(v, dihedral.d)};
    const auto to_vertices = [&](const Vector3<S>& q0, const Vector3<S>& q1,
                                 std::array<Vector3<S>, 4>& q) {
      const Vector3<S> shared = a * q0 + c * q1;
      q[0] = q0;
      q[1] = shared - q0;
      q[2] = -shared - q1;
      q[3] = q1;
    };

    const S force = dihedral.stiffness * g;
    to_vertices(force * plane.b0, -force * plane.b1, derivatives.gradient);

    constexpr std::size_t half = filter == Filter::tight ? 2 : 4;
    std::array<RankOne<S, 4>, 2 * half> terms;
    const auto in_plane = in_plane_terms<S, half>(plane, g, S(1));
    for (std::size_t i = 0; i < half; ++i) {
      terms[i].weight = in_plane[i].weight;
      to_vertices(in_plane[i].q0, in_plane[i].q1, terms[i].q);
    }
    set_axial_terms(dihedral, sqrt(inverse_uu), sqrt(inverse_vv), g,
                    std::span<RankOne<S, 4>, half>(terms.data() + half, half));
    for (RankOne<S, 4>& term : terms) term.weight = dihedral.stiffness * term.weight;
    derivatives.set_hessian(terms);
  }

  /// The part of the Hessian that moves u and v along e1. With s = +1 where cos tau >= 0 and -1
  /// elsewhere, the in-plane unit vectors f = unit(u/|u| + s v/|v|) and f' = d x f, and
  /// kappa(s) = (1, a-1, -a, 0)/|u| + s (0, c, -(c+1), 1)/|v|, it is exactly
  ///
  ///     P(f, s,  g s sin(tau), g s sin(tau) / 2m) + P(f', -s, -g s sin(tau), g m)
  ///     P(f, s, p, q) = p/|e1|^2 F F^T - q/|e1| (F K^T + K F^T)
  ///     F = (0, f, -f, 0),  K = kappa(s) x d (a vector along d a vertex)
  ///
  /// where m = cos of half the angle between u and s v: it lies in [1/sqrt(2), 1], so that no term
  /// has a pole. F and K are orthogonal: each P has one positive and one negative eigenvalue, those
  /// of a 2x2 matrix. First the positive parts; with four terms the negative ones behind them.
  template <class S, std::size_t N>
  static void set_axial_terms(const Dihedral<S>& dihedral, const S& inverse_u, const S& inverse_v,
                              const S& g, std::span<RankOne<S, 4>, N> terms) {
    const S& a = dihedral.a;
    const S& c = dihedral.c;
    const S& inverse_length = dihedral.inverse_length;
    const S s = copysign(S(1), dihedral.cosine);
    const S signed_inverse_v = s * inverse_v, scale = inverse_u * signed_inverse_v;
    const S cosine = dihedral.cosine * scale, sine = dihedral.sine * scale;
    const S m = sqrt(max(S(0.5) + S(0.5) * cosine, S(0.5)));
    const S half_inverse_m = S(0.5) / m;
    const Vector3<S> f = (half_inverse_m * inverse_u) * dihedral.u +
                         (half_inverse_m * signed_inverse_v) * dihedral.v;
    const std::array<S, 4> kappa_u{inverse_u, (a - S(1)) * inverse_u, -a * inverse_u, S(0)};
    const std::array<S, 4> kappa_v{S(0), c * signed_inverse_v, -(c + S(1)) * signed_inverse_v,
                                   signed_inverse_v};

    const S g_per_length = g * inverse_length;
    const S h = g_per_length * sine * inverse_length;
    const auto set = [&](std::size_t i, const Vector3<S>& direction, double sign, const S& h_of_f,
                         const S& q) {
      std::array<S, 4> kappa;
      S squared = 0;
      for (int n = 0; n < 4; ++n) {
        kappa[n] = kappa_u[n] + sign * kappa_v[n];
        squared += kappa[n] * kappa[n];
      }
      const SplitPair<S> split = split_pair(S(q * sqrt(S(2) * squared)), h_of_f);
      const auto set_term = [&](RankOne<S, 4>& term, const S& weight, const S& along) {
        const Vector3<S> across = along * direction;
        term.weight = S(0.5) * weight;
        for (int n = 0; n < 4; ++n) term.q[n] = (S(-2) * q * kappa[n]) * dihedral.d;
        term.q[1] += across;
        term.q[2] -= across;
      };
      set_term(terms[i], split.weight, split.positive);
      if constexpr (N == 4) set_term(terms[2 + i], -split.weight, split.negative);
    };
    set(0, f, 1, h, g_per_length * sine * half_inverse_m);
    set(1, cross(dihedral.d, f), -1, -h, g_per_length * m);
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
