# Builds against the ringlet installed in PREFIX the consumer, the example plugins and what `ringlet
# new` writes of every kind, and runs their tests and scenes with the installed program. Called by
# CTest with PREFIX, SOURCE, EXAMPLES, WORK, CXX, CXX_FLAGS, GENERATOR and VALIDATE_SCHEMA, the
# command that tries the schema of scenes, empty where it cannot be run.
function(must)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}: ${result}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
set(ringlet ${PREFIX}/bin/ringlet)
function(build source folder type)
  must(${CMAKE_COMMAND} -S ${source} -B ${folder} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${type}
       -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${CXX_FLAGS}
       -DCMAKE_PREFIX_PATH=${PREFIX})
  must(${CMAKE_COMMAND} --build ${folder} --parallel 1)
endfunction()

build(${SOURCE} ${WORK}/build Debug)
must(${WORK}/build/consumer)
must(${ringlet} check ${PREFIX}/share/ringlet/scenes/first_curl.json)

file(GLOB examples ${EXAMPLES}/*/CMakeLists.txt)
set(projects "")
foreach(example IN LISTS examples)
  get_filename_component(folder ${example} DIRECTORY)
  get_filename_component(name ${folder} NAME)
  file(COPY ${folder} DESTINATION ${WORK})
  list(APPEND projects ${WORK}/${name})
endforeach()
foreach(kind energy solver collider writer)
  must(${ringlet} new ${kind} my_${kind} ${WORK}/my_${kind})
  list(APPEND projects ${WORK}/my_${kind})
endforeach()

# One configuration for all.
file(COPY_FILE ${SOURCE}/plugins.cmake ${WORK}/CMakeLists.txt)
build(${WORK} ${WORK}/plugins Release)
must(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/plugins --output-on-failure)
set(plugins "")
set(scenes "")
foreach(folder IN LISTS projects)
  must(${ringlet} run ${folder}/scene.json -o ${folder}/results --quiet)
  # What was written of the scene names the plugin, too.
  must(${ringlet} check ${folder}/results/scene.resolved.json)
  get_filename_component(name ${folder} NAME)
  list(APPEND plugins --plugin ${folder}/build/${name}.so)
  list(APPEND scenes ${folder}/scene.json ${folder}/results/scene.resolved.json)
endforeach()
if(VALIDATE_SCHEMA)
  must(${VALIDATE_SCHEMA} ${ringlet} ${plugins} --accepts ${scenes})
endif()
