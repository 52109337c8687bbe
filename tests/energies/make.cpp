#include "tests/energies/make.h"

#include "core/read_choice.h"
#include "energies/modules.h"

namespace ringlet::test {

namespace {

template <class Interface>
std::unique_ptr<Interface> make(const Json& json) {
  Registry registry;
  register_energies(registry);
  return make_chosen<Interface>(registry, json);
}

}  // namespace

std::unique_ptr<Energy> make_energy(const Json& json) { return make<Energy>(json); }
std::unique_ptr<Force> make_force(const Json& json) { return make<Force>(json); }

BoundEnergy bound(const std::string& name, const Points& rest, const std::string& filter) {
  return {make_energy({{"type", name}, {"filter", filter}}), rest};
}

}  // namespace ringlet::test
