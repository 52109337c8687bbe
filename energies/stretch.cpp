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
    S stiffness;  ///< k, J
    S length;     ///< l, m
  };

  [[no_unique_address]] Parameters parameters;

  Rest<double> rest(const ElementRest<2>& element) const {
    const double length = element.lengths[0];
    const double area = circle_area(0.5 * (element.radii[0] + element.radii[1]));
    // An edge without rest length has no strain.
    if (length == 0) return {0, 1};
    return {element.material.youngs_modulus * area * length, length};
  }

  Rest<double> rest_of(double stiffness, double length) const { return {stiffness, length}; }

  template <class S>
  S value(const Stencil<S, 2>& x, const Rest<S>& rest) const {
    const S strain = norm(x[1] - x[0]) * (S(1) / rest.length) - S(1);
    return S(0.5) * rest.stiffness * strain * strain;
  }

  template <class S>
  S evaluate(const Stencil<S, 2>& x, const Rest<S>& rest, Filter filter,
             Derivatives<S, 2>& derivatives) const {
    // Below this fraction of its rest length an edge has no direction of its own; it opens along x.
    constexpr double collapsed = 1e-8;
    Vector3<S> edge = x[1] - x[0];
    S length = norm(edge);
    const S inverse_rest = S(1) / rest.length;
    const S strain = length * inverse_rest - S(1);
    const auto has_no_direction = length < collapsed * rest.length;
    if (any(has_no_direction)) {
      length = select(has_no_direction, S(collapsed * rest.length), length);
      edge = select(has_no_direction, Vector3<S>{length, S(0), S(0)}, edge);
    }
    const S inverse_length = S(1) / length;
    const Vector3<S> t = inverse_length * edge;
    const S tension = rest.stiffness * inverse_rest * strain;
    derivatives.gradient[1] = tension * t;
    derivatives.gradient[0] = -derivatives.gradient[1];

    const S along = rest.stiffness * inverse_rest * inverse_rest;
    S across = tension * inverse_length;
    if (filter == Filter::tight || filter == Filter::paper) across = max(across, S(0));
    if (filter == Filter::gauss_newton) across = S(0);
    const Vector3<S> difference = (along - across) * t;
    const auto set = [&](int row, int column, const S& entry) {
      for (const int m : {3 * row + column, 3 * column + row}) {
        derivatives.block(0, 0).m[m] = entry;
        derivatives.block(1, 0).m[m] = -entry;
        derivatives.block(1, 1).m[m] = entry;
      }
    };
    set(0, 0, difference.x * t.x + across);
    set(1, 1, difference.y * t.y + across);
    set(2, 2, difference.z * t.z + across);
    set(1, 0, difference.x * t.y);
    set(2, 0, difference.x * t.z);
    set(2, 1, difference.y * t.z);
    return S(0.5) * rest.stiffness * strain * strain;
  }
};

}  // namespace

void register_stretch(Registry& registry);
void register_stretch(Registry& registry) {
  register_energy<Stretch>(registry, "stretch",
                           {"resistance of the edges to a change of length",
                            "k/2 (|e|/l - 1)^2, k = EA l", "math.md, section 1"});
}

}  // namespace ringlet
