// Bending as a spring across the hinge. Its value is all that is written here: gradient and Hessian
// are found by automatic differentiation.

#include "core/batch_energy.h"
#include "core/plugin.h"

namespace {

using namespace ringlet;

/// E = k/2 (|x2 - x0| / c - 1)^2, k = EA c, c the chord at rest.
struct ChordBend {
  static constexpr int vertices = 3;
  using Parameters = NoParameters;
  Parameters parameters;

  template <class S>
  struct Rest {
    S stiffness;  // J
    S chord;      // m
  };

  Rest<double> rest(const ElementRest<3>& element) const {
    const double chord = norm(element.positions[2] - element.positions[0]);
    return {element.material.youngs_modulus * circle_area(element.radii[1]) * chord, chord};
  }

  template <class S>
  S value(const Stencil<S, 3>& x, const Rest<S>& rest) const {
    const S strain = norm(x[2] - x[0]) / rest.chord - S(1);
    return S(0.5) * rest.stiffness * strain * strain;
  }
};

void register_chord_bend(Registry& registry) {
  register_energy<ChordBend>(
      registry, "chord_bend",
      {"a spring across each hinge", "k/2 (|x2 - x0| / c - 1)^2", "plugins/chord_bend"});
}

}  // namespace

RINGLET_PLUGIN(register_chord_bend);
