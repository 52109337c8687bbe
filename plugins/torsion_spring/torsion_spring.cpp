// Bending and torsion as springs between the ends of three and of four consecutive vertices (Selle,
// Lentine, Fedkiw 2008, "A mass spring model for hair simulation"). With d the chord from the first
// vertex to the last one, c its length at rest, and t = d/|d|:
//
//     W = k/2 (|d| - c)^2,  k = G r
//     dW/dd = k (|d| - c) t
//     d2W/dd2 = k t t^T + k (1 - c/|d|) (I - t t^T)
//
// The chord is the sum of the edges, hence the same derivatives for each of them. Only the
// transverse eigenvalue k (1 - c/|d|) can be negative, where the chord is shorter than at rest.

#include <numeric>
#include <optional>

#include "core/batch_energy.h"
#include "core/plugin.h"

namespace {

using namespace ringlet;

struct SpringParameters {
  std::optional<double> stiffness;

  static Schema<SpringParameters> schema() {
    return Schema<SpringParameters>().key(
        "stiffness", &SpringParameters::stiffness, "N/m", positive(),
        "k of every spring; shear modulus times radius if absent");
  }
};

/// A spring between the ends of K vertices.
template <int K>
struct ChordSpring {
  static constexpr int vertices = K;
  using Parameters = SpringParameters;
  Parameters parameters;

  /// Lengths are relative to that of the edges together, so that no square underflows.
  template <class S>
  struct Rest {
    S stiffness;       ///< k l^2, J
    S inverse_length;  ///< 1/l, 1/m
    S chord;           ///< c/l
  };

  Rest<double> rest(const ElementRest<K>& element) const {
    constexpr double shortest = 1e-150;  // m, whose inverse has a square
    const double length = std::accumulate(element.lengths.begin(), element.lengths.end(), 0.0);
    if (length < shortest) return {0, 1, 0};
    const double radius = 0.5 * (element.radii[1] + element.radii[K - 2]);
    const double k = parameters.stiffness.value_or(element.material.shear() * radius);
    const double chord = norm(element.positions[K - 1] - element.positions[0]);
    return {k * length * length, 1 / length, chord / length};
  }

  template <class S>
  S value(const Stencil<S, K>& x, const Rest<S>& rest) const {
    const S stretch = norm(rest.inverse_length * (x[K - 1] - x[0])) - rest.chord;
    return S(0.5) * rest.stiffness * stretch * stretch;
  }

  template <class S>
  S evaluate(const Stencil<S, K>& x, const Rest<S>& rest, Filter filter,
             ElementOutputs<S, K> outputs) const {
    const Chord<S> chord(rest.inverse_length * (x[K - 1] - x[0]));
    const S stretch = chord.length - rest.chord;
    const S tension = rest.stiffness * rest.inverse_length * stretch;
    const S along = rest.stiffness * rest.inverse_length * rest.inverse_length;
    S across = tension * rest.inverse_length * chord.inverse;
    if (filter == Filter::tight || filter == Filter::paper) across = max(across, S(0));
    if (filter == Filter::gauss_newton) across = S(0);

    const Vector3<S>& t = chord.direction;
    Matrix3<S> hessian = Matrix3<S>::zero();
    add_outer_product(hessian, (along - across) * t, t);
    for (int i = 0; i < 3; ++i) hessian(i, i) += across;
    for (int row = 0; row < K - 1; ++row) {
      outputs.add_gradient(row, tension * t);
      for (int column = 0; column <= row; ++column) outputs.block(row, column) += hessian;
    }
    return S(0.5) * rest.stiffness * stretch * stretch;
  }

 private:
  /// Length and direction of a chord. One that has collapsed has no direction: it opens along x,
  /// and its inverse length is bounded.
  template <class S>
  struct Chord {
    S length, inverse;
    Vector3<S> direction;

    explicit Chord(const Vector3<S>& d) {
      constexpr double collapsed = 1e-8;
      const S squared = squared_norm(d);
      const auto has_no_direction = squared < S(collapsed * collapsed);
      length = sqrt(squared);
      inverse = S(1) / max(length, S(collapsed));
      direction = select(has_no_direction, Vector3<S>{S(1), S(0), S(0)}, inverse * d);
    }
  };
};

void register_springs(Registry& registry) {
  const std::string equation = "k/2 (|d| - c)^2, d the chord", source = "Selle et al. 2008";
  register_energy<ChordSpring<3>>(
      registry, "bending_spring",
      {"a spring between the ends of three vertices, against bending", equation, source});
  register_energy<ChordSpring<4>>(
      registry, "torsion_spring",
      {"a spring between the ends of four vertices, against torsion", equation, source});
}

}  // namespace

RINGLET_PLUGIN(register_springs);
