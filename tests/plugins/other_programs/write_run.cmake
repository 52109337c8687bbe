# cmake -DRINGLET=... -DSCENE=... -DRUN=... -P write_run.cmake
file(REMOVE_RECURSE ${RUN})
execute_process(COMMAND ${RINGLET} run ${SCENE} --output ${RUN} --quiet RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "ringlet run failed")
endif()
execute_process(COMMAND ${RINGLET} convert ${RUN} ${RUN}/edges
                        --write "{\"type\": \"obj\", \"lines\": \"edges\"}"
                RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "ringlet convert failed")
endif()
