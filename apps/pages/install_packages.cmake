# Installs the packages that the pages are made of in WORK and writes WORK/packages.txt: "installed",
# or why they are not.
#   cmake -DNODE= -DNPM= -DPACKAGES= -DSOURCE= -DWORK= -P install_packages.cmake

if(NOT NODE OR NOT NPM)
  file(WRITE ${WORK}/packages.txt "node and npm were not found. Install Node 18 or newer with npm \
(Debian: nodejs npm), then `cmake --preset release` and build again")
  return()
endif()

file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/build.mjs DESTINATION ${WORK})
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
endif()
if(result EQUAL 0)
  file(WRITE ${WORK}/installed.txt "${wanted}")
  file(WRITE ${WORK}/packages.txt "installed")
else()
  message("${text}\nThe packages of the pages could not be installed; going on without pages.")
  file(WRITE ${WORK}/packages.txt "npm failed when it was built (is there a network?). Remove \
${WORK}/packages.txt and build again to see why")
endif()
