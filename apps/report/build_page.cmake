# Bundles the page and writes it as the C++ file OUT, in a copy of its sources so that nothing
# appears beside them. Where that cannot be done, OUT says why when the page is asked for.
#   cmake -DNODE= -DNPM= -DPACKAGES= -DSOURCE= -DWORK= -DOUT= -P build_page.cmake

function(write_absence reason)
  file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT [[
#include "apps/report/page.h"

#include "core/error.h"

namespace ringlet {

std::string page_template() {
  throw Error(R"text(this ringlet was built without the page of its reports: @reason@)text");
}

}  // namespace ringlet
]])
endfunction()

if(NOT NODE OR NOT NPM)
  write_absence("node and npm were not found. Install Node 18 or newer with npm (Debian: nodejs npm), \
then `cmake --preset release` and build again")
  return()
endif()

file(COPY ${SOURCE}/ DESTINATION ${WORK} PATTERN node_modules EXCLUDE)
file(SHA256 ${WORK}/package-lock.json wanted)
string(APPEND wanted " ${PACKAGES}")
set(installed "")
if(EXISTS ${WORK}/installed.txt)
  file(READ ${WORK}/installed.txt installed)
endif()
set(result 0)
if(NOT installed STREQUAL wanted)
  execute_process(
    COMMAND ${NPM} ci ${PACKAGES} --ignore-scripts --no-audit --no-fund --loglevel=error
            --fetch-retries=1 --fetch-timeout=20000
    WORKING_DIRECTORY ${WORK} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(result EQUAL 0)
    file(WRITE ${WORK}/installed.txt "${wanted}")
  endif()
endif()
if(result EQUAL 0)
  execute_process(COMMAND ${NODE} build.mjs ${OUT} WORKING_DIRECTORY ${WORK}
                  RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
endif()
if(NOT result EQUAL 0)
  message("${text}\nThe page of `ringlet report` could not be bundled; going on without it.")
  write_absence("npm or the bundler failed when it was built (is there a network?). Remove ${OUT} and \
build again to see why")
endif()
