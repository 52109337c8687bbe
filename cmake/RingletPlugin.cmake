# ringlet_add_plugin(NAME SOURCE...)
#
# A plugin library NAME.so, for "plugins" of a scene or --plugin. One of the sources has
# RINGLET_PLUGIN(...) of core/plugin.h in it.
function(ringlet_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE ringlet::core)
  target_compile_features(${name} PRIVATE cxx_std_20)
  # Without a build type nothing would be optimised, and a kernel take a hundred times as long.
  target_compile_options(${name} PRIVATE $<$<CONFIG:>:-O3>)
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX ".so" CXX_EXTENSIONS OFF)
endfunction()
