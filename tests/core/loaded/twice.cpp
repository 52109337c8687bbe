// A plugin that offers a second thing of one name, after a right one.
#include "tests/core/loaded/nothing.h"

namespace {

void register_twice(ringlet::Registry& registry) {
  ringlet::register_nothing(registry);
  ringlet::register_nothing(registry);
}

}  // namespace

RINGLET_PLUGIN(register_twice);
