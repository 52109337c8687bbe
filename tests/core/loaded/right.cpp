// A plugin as it should be.
#include "tests/core/loaded/nothing.h"

RINGLET_PLUGIN(ringlet::register_nothing);
