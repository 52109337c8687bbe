// Bending as a spring across the hinge. Its value is all that is written here: gradient and Hessian
// are found by automatic differentiation.

#include "core/batch_energy.h"
#include "core/plugin.h"

namespace {

using namespace ringlet;

/// W = k/2 (|x2 - x0| - c)^2, k = E r, c the chord at rest.
struct ChordBend {
  static constexpr int vertices = 3;
  using Parameters = NoParameters;
  Parameters parameters;

  template <class S>
  struct Rest {
    S stiffness;  // N/m
    S chord;      // m
  };

  Rest<double> rest(const ElementRest<3>& element) const {
    return {element.material.youngs_modulus * element.radii[1],
            norm(element.positions[2] - element.positions[0])};
  }

  template <class S>
  S value(const Stencil<S, 3>& x, const Rest<S>& rest) const {
    const S stretch = norm(x[2] - x[0]) - rest.chord;
    return S(0.5) * rest.stiffness * stretch * stretch;
  }
};

void register_chord_bend(Registry& registry) {
  register_energy<ChordBend>(
      registry, "chord_bend",
      {"a spring across each hinge", "k/2 (|x2 - x0| - c)^2", "plugins/chord_bend"});
}

}  // namespace

RINGLET_PLUGIN(register_chord_bend);
