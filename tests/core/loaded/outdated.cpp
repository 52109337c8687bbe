// A plugin of another ringlet.
#include "core/plugin.h"

extern "C" const ringlet::PluginStamp ringlet_plugin_stamp;
extern "C" const ringlet::PluginStamp ringlet_plugin_stamp{"0.0.9", ringlet::this_build.compiler,
                                                           ringlet::this_build.lanes,
                                                           ringlet::this_build.eigen_alignment};
extern "C" void ringlet_plugin_register(ringlet::Registry&);
extern "C" void ringlet_plugin_register(ringlet::Registry&) {}
