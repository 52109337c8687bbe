# Installs ringlet to a folder of its own, builds the consumer and the example plugins against it, and
# runs them and the installed program there. Called by CTest with BUILD, SOURCE, EXAMPLES, WORK and
# CXX.
function(must)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}: ${result}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
must(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
function(build source folder type)
  must(${CMAKE_COMMAND} -S ${source} -B ${folder} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${type}
       -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${CXX_FLAGS}
       -DCMAKE_PREFIX_PATH=${WORK}/prefix)
  must(${CMAKE_COMMAND} --build ${folder})
endfunction()

build(${SOURCE} ${WORK}/build Debug)
must(${WORK}/build/consumer)
must(${WORK}/prefix/bin/ringlet check ${WORK}/prefix/share/ringlet/scenes/first_curl.json)

# As the README of an example says.
function(try_plugin folder)
  build(${folder} ${folder}/build Release)
  must(${CMAKE_CTEST_COMMAND} --test-dir ${folder}/build --output-on-failure)
  must(${WORK}/prefix/bin/ringlet run ${folder}/scene.json -o ${folder}/results --quiet)
  # What was written of the scene names the plugin, too.
  must(${WORK}/prefix/bin/ringlet check ${folder}/results/scene.resolved.json)
endfunction()

file(COPY ${EXAMPLES}/chord_bend DESTINATION ${WORK})
try_plugin(${WORK}/chord_bend)
must(${WORK}/prefix/bin/ringlet new energy my_bend ${WORK}/my_bend)
try_plugin(${WORK}/my_bend)
