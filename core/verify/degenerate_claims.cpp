#include "core/verify/subject.h"

namespace ringlet {

void claim_degenerate(const Subject& subject, std::vector<Claim>& claims) {
  Claim finite{"finite in degenerate states", 0};
  Claim semidefinite{"positive semi-definite in degenerate states", 1e-9};
  std::mt19937_64 random(subject.seed);
  std::vector<NamedShape> rests = singular_shapes(subject.vertices);
  rests.push_back({"generic", random_strand(random, subject.vertices, Shape::generic)});
  const std::vector<NamedShape> shapes = degenerate_shapes(random, subject.vertices);
  for (const std::string& filter : subject.variants()) {
    for (const NamedShape& rest : rests) {
      const BoundEnergy energy(subject.energy(filter), rest.x);
      for (const NamedShape& shape : shapes) {
        const std::string name =
            filter + (filter.empty() ? "" : "; ") + "rest " + rest.name + "; now " + shape.name;
        const Probe probe = energy.at(shape.x);
        const bool is_finite = probe.is_finite() && std::isfinite(energy.value(shape.x));
        finite.see(is_finite ? 0 : std::nan(""), name);
        if (filter == "exact" || !is_finite) continue;
        semidefinite.see(negative_part(probe.hessian, largest_entry(probe.hessian)), name);
      }
    }
  }
  claims.push_back(std::move(finite));
  claims.push_back(std::move(semidefinite));
}

}  // namespace ringlet
