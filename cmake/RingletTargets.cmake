# ringlet_library(NAME SOURCES ... MODULES ... [LINKS ...])
#
# A library ringlet_NAME, alias ringlet::NAME. Each MODULE is a source MODULE.cpp that defines
# `void ringlet::register_MODULE(Registry&)`; a generated table calls them all, in this order, from
# `void ringlet::register_NAME(Registry&)`, which NAME/modules.h declares. Adding a plugin is one
# line: its name in MODULES.
function(ringlet_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;MODULES;LINKS")
  set(target ringlet_${name})
  set(table ${CMAKE_CURRENT_BINARY_DIR}/${name}_table.cpp)
  set(module_sources "")
  set(declarations "")
  set(calls "")
  foreach(module IN LISTS arg_MODULES)
    get_filename_component(base ${module} NAME)
    list(APPEND module_sources ${module}.cpp)
    string(APPEND declarations "void register_${base}(Registry&);\n")
    string(APPEND calls "  register_${base}(registry);\n")
  endforeach()
  file(CONFIGURE OUTPUT ${table} @ONLY CONTENT [[
// Written by CMake from the list of modules.
#include "core/registry.h"
#include "@name@/modules.h"

namespace ringlet {

@declarations@
void register_@name@(Registry& registry) {
@calls@}

}  // namespace ringlet
]])
  add_library(${target} ${arg_SOURCES} ${module_sources} ${table})
  add_library(ringlet::${name} ALIAS ${target})
  target_link_libraries(${target} PUBLIC ${arg_LINKS})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION}
                                             SOVERSION ${PROJECT_VERSION_MAJOR} DEFINE_SYMBOL "")
  ringlet_own_code(${target})
  if(target STREQUAL "ringlet_core")
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
  else()
    ringlet_reuse_headers(${target})
  endif()
endfunction()

# Takes the headers of core as they were compiled for core, which is position independent.
function(ringlet_reuse_headers target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_precompile_headers(${target} REUSE_FROM ringlet_core)
endfunction()

# Settings of every target whose sources are ours.
function(ringlet_own_code target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                                           -Wold-style-cast -Woverloaded-virtual)
  # No function of a library is meant to be replaced by one of the program: so they can be inlined.
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 14)
    # False alarms of its own AVX-512 headers (GCC bug 105593).
    target_compile_options(${target} PRIVATE -Wno-uninitialized -Wno-maybe-uninitialized)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC bug 105651: false alarms at "text" + std::string.
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-stringop-overflow
                                             -Wno-stringop-overread -Wno-array-bounds)
  endif()
  if(RINGLET_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
