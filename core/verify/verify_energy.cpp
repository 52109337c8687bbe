#include "core/verify/verify_energy.h"

#include "core/read_choice.h"
#include "core/verify/subject.h"

namespace ringlet {

EnergyMaker energy_maker(const Registry& registry, const Json& choice) {
  make_chosen<Energy>(registry, choice);
  const Json object = choice.is_string() ? Json{{"type", choice}} : choice;
  return [&registry, object](const Json& keys) -> std::unique_ptr<Energy> {
    Json all = object;
    all.update(keys);
    std::vector<Problem> refused;
    const auto energy = read_choice<Energy>(registry, all, refused);
    return refused.empty() ? energy.make() : nullptr;
  };
}

std::vector<Claim> verify_energy(const EnergyMaker& make, const VerifyOptions& options) {
  const Subject subject(make, options);
  std::vector<Claim> claims;
  claim_derivatives(subject, claims);
  claim_invariance(subject, claims);
  claim_filters(subject, claims);
  claim_assembly(subject, claims);
  claim_holding(subject, claims);
  claim_degenerate(subject, claims);
  return claims;
}

}  // namespace ringlet
