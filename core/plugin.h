#pragma once

#include <Eigen/Core>

#include "core/lanes.h"
#include "core/registry.h"
#include "core/version.h"

namespace ringlet {

/// What a plugin library and the program that loads it must have in common: else they would read
/// each other's memory wrongly.
struct PluginStamp {
  const char* version;  ///< of ringlet
  const char* compiler;
  int lanes;            ///< doubles in a Pack, which depend on the processor compiled for
  int eigen_alignment;  ///< bytes; EIGEN_MAX_ALIGN_BYTES
};

#if defined(__clang__)
inline constexpr const char* compiler_family = "clang";
#else
inline constexpr const char* compiler_family = "gcc";
#endif

inline constexpr PluginStamp this_build{version, compiler_family, lane_count,
                                        EIGEN_MAX_ALIGN_BYTES};

/// Why what has this stamp cannot be used together with this build; empty if it can.
std::string difference(const PluginStamp& stamp);

}  // namespace ringlet

/// Makes a library a plugin, once in it: register_plugin is a function void(ringlet::Registry&)
/// that adds what the library has to offer.
#define RINGLET_PLUGIN(register_plugin)                                             \
  extern "C" const ringlet::PluginStamp ringlet_plugin_stamp;                       \
  extern "C" const ringlet::PluginStamp ringlet_plugin_stamp = ringlet::this_build; \
  extern "C" void ringlet_plugin_register(ringlet::Registry& registry);             \
  extern "C" void ringlet_plugin_register(ringlet::Registry& registry) {            \
    register_plugin(registry);                                                      \
  }                                                                                 \
  static_assert(true, "for the semicolon")
