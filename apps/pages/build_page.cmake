# Bundles a page and writes it as the C++ file OUT, in a copy of its sources so that nothing appears
# beside them. Where that cannot be done, OUT says why when the page is asked for.
#   cmake -DNAME= -DNODE= -DSOURCE= -DWORK= -DOUT= -P build_page.cmake

function(write_absence reason)
  file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT [[
#include "apps/pages/page_templates.h"

#include "core/error.h"

namespace ringlet {

std::string @NAME@_page_template() {
  throw Error(R"text(this ringlet was built without the page of `ringlet @NAME@`: @reason@)text");
}

}  // namespace ringlet
]])
endfunction()

file(READ ${WORK}/packages.txt packages)
if(NOT packages STREQUAL "installed")
  write_absence("${packages}")
  return()
endif()
file(COPY ${SOURCE}/ DESTINATION ${WORK}/${NAME} PATTERN node_modules EXCLUDE)
execute_process(COMMAND ${NODE} build.mjs ${NAME} ${NAME} ${OUT} WORKING_DIRECTORY ${WORK}
                RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(NOT result EQUAL 0)
  message("${text}\nThe page of `ringlet ${NAME}` could not be bundled; going on without it.")
  write_absence("the bundler failed when it was built. Remove ${OUT} and build again to see why")
endif()
