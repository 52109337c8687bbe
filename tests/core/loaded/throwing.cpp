// A plugin that fails as it registers.
#include <stdexcept>

#include "core/plugin.h"

namespace {

void register_throwing(ringlet::Registry&) { throw std::runtime_error("out of ideas"); }

}  // namespace

RINGLET_PLUGIN(register_throwing);
