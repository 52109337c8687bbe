// A plugin that lacks a function.
#include "core/plugin.h"

void written_nowhere();

namespace {

void register_incomplete(ringlet::Registry&) { written_nowhere(); }

}  // namespace

RINGLET_PLUGIN(register_incomplete);
