// Stretching of an edge e of rest length l (math.md, section 1):
//
//     E = k/2 (|e|/l - 1)^2,  k = EA l
//     dE/de = (k/l) (|e|/l - 1) t,  t = e/|e|
//     d2E/de2 = (k/l^2) (t t^T + (1 - l/|e|) (I - t t^T))
//
// Only the transverse eigenvalue 1 - l/|e| can be negative, in a compressed edge.

#include "core/batch_energy.h"

namespace ringlet {

namespace {

struct Stretch {
  using Parameters = NoParameters;
  static constexpr int vertices = 2;

  template <class S>
  struct Rest {
    S stiffness;       ///< k, J
    S inverse_length;  ///< 1 / l, 1/m
  };

  [[no_unique_address]] Parameters parameters;

  Rest<double> rest(const ElementRest<2>& element) const {
    const double length = element.lengths[0];
    const double area = circle_area(0.5 * (element.radii[0] + element.radii[1]));
    // An edge without rest length has no strain.
    if (length < shortest) return {0, 1};
    return {element.material.youngs_modulus * area * length, 1 / length};
  }

  Rest<double> rest_of(double stiffness, double length) const { return {stiffness, 1 / length}; }

  /// The tension is EA times the slope, with the rest length |e| / (1 + slope).
  Hold hold(const Stencil<double, 2>& x, double slope, Rest<double>& rest) const {
    const double length = norm(x[1] - x[0]);
    if (!(rest.stiffness > 0) || length < shortest || slope <= -1) return Hold::impossible;
    const double rest_length = length / (1 + slope);
    rest = {rest.stiffness * rest.inverse_length * rest_length, 1 / rest_length};
    return Hold::exact;
  }

  template <class S>
  S value(const Stencil<S, 2>& x, const Rest<S>& rest) const {
    const S strain = norm(x[1] - x[0]) * rest.inverse_length - S(1);
    return S(0.5) * rest.stiffness * strain * strain;
  }

  template <class S>
  S evaluate(const Stencil<S, 2>& x, const Rest<S>& rest, Filter filter,
             ElementOutputs<S, 2> outputs) const {
    // Below this fraction of its rest length an edge has no direction of its own; it opens along x.
    constexpr double collapsed = 1e-8;
    // Relative to the rest length, so that no square underflows.
    Vector3<S> edge = rest.inverse_length * (x[1] - x[0]);
    S squared = squared_norm(edge);
    const auto has_no_direction = squared < S(collapsed * collapsed);
    S offset = 0;  // of the strain, where the edge is shorter than its stand-in
    if (any(has_no_direction)) {
      offset = select(has_no_direction, S(sqrt(squared) - collapsed), S(0));
      squared = select(has_no_direction, S(collapsed * collapsed), squared);
      edge = select(has_no_direction, Vector3<S>{S(collapsed), S(0), S(0)}, edge);
    }
    const S inverse = inverse_sqrt(squared);
    // Strains are small differences of lengths: the last digits of the root matter.
    const S estimate = squared * inverse;
    const S length = estimate + S(0.5) * inverse * (squared - estimate * estimate);
    const S strain = length + offset - S(1);
    const Vector3<S> t = inverse * edge;
    const S tension = rest.stiffness * rest.inverse_length * strain;
    outputs.add_gradient(0, tension * t);

    const S along = rest.stiffness * rest.inverse_length * rest.inverse_length;
    S across = tension * rest.inverse_length * inverse;
    if (filter == Filter::tight || filter == Filter::paper) across = max(across, S(0));
    if (filter == Filter::gauss_newton) across = S(0);
    const Vector3<S> difference = (along - across) * t;
    Matrix3<S>& block = outputs.block(0, 0);
    block.m[0] += difference.x * t.x + across;
    block.m[3] += difference.y * t.x;
    block.m[4] += difference.y * t.y + across;
    block.m[6] += difference.z * t.x;
    block.m[7] += difference.z * t.y;
    block.m[8] += difference.z * t.z + across;
    return S(0.5) * rest.stiffness * strain * strain;
  }

 private:
  /// Of a rest length that has an inverse with squares, m.
  static constexpr double shortest = 1e-150;
};

}  // namespace

void register_stretch(Registry& registry);
void register_stretch(Registry& registry) {
  register_energy<Stretch>(registry, "stretch",
                           {"resistance of the edges to a change of length",
                            "k/2 (|e|/l - 1)^2, k = EA l", "math.md, section 1"});
}

}  // namespace ringlet
