#include "apps/validate/validation.h"

#include <cmath>

namespace ringlet {

double ValidationRow::error() const {
  const double difference = std::abs(measured - expected);
  return expected == 0 ? difference : difference / std::abs(expected);
}

bool ValidationRow::passes() const {
  const bool is_near = error() <= tolerance;
  return is_near && (!least_order || (order && *order >= *least_order));
}

std::vector<ValidationCase> all_validation_cases() {
  return {
      {"cantilever", "a clamped rod bends under its own weight",
       "shooting for B theta'' = w (L - s) cos theta", validate_cantilever},
      {"elastica", "a clamped rod bends under a load at its tip", "Bisshopp and Drucker 1945",
       validate_elastica},
      {"ring", "an end moment 2 pi B / L closes a rod to a ring", "Euler", validate_ring},
      {"buckling", "columns buckle under a load, and under their own weight",
       "Euler; Greenhill 1881", validate_buckling},
      {"wire", "a hanging wire is stretched", "Hooke", validate_wire},
      {"catenary", "a chain hangs between two points", "Bernoulli, Leibniz, Huygens 1691",
       validate_catenary},
      {"spring", "a helical spring sags under its own weight", "Love 1927, section 271",
       validate_spring},
      {"cantilever_modes", "frequencies of a clamped rod", "beta^2 of cos b cosh b = -1",
       validate_cantilever_modes},
      {"chain_modes", "frequencies of a hanging chain", "zeros of J0", validate_chain_modes},
      {"free_fall", "what nothing holds falls, and keeps its shape and momentum", "Galilei",
       validate_free_fall},
      {"rigid_motion", "what moves as a whole keeps its energy", "symmetry", validate_rigid_motion},
      {"incline", "a strand sticks to a slope, or slides", "Coulomb 1785", validate_incline},
      {"capstan", "a rope slides around a cylinder", "Euler, Eytelwein", validate_capstan},
      {"sag_free", "a curl whose rest state holds its weight stays", "equilibrium",
       validate_sag_free}};
}

}  // namespace ringlet
