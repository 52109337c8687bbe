// A plugin library of an energy with mistakes, for `ringlet verify --plugin`.
#include "tests/energies/wrong_bending.h"

#include "core/plugin.h"

namespace {

void register_wrong_bending(ringlet::Registry& registry) {
  ringlet::register_energy<ringlet::WrongBending>(registry, "wrong_bending", {});
}

}  // namespace

RINGLET_PLUGIN(register_wrong_bending);
