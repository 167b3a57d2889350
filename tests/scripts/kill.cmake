# A run killed at 20 random moments ends like one that nobody touched.
add_test(NAME script.kill COMMAND /usr/bin/python3 -B ${CMAKE_SOURCE_DIR}/tests/python/kill.py $<TARGET_FILE:scree>
                                  ${CMAKE_CURRENT_BINARY_DIR}/kill 20)
set_tests_properties(script.kill PROPERTIES LABELS long ENVIRONMENT OMP_WAIT_POLICY=passive)

# The same of two ranks, one of which is killed at 50 random moments.
if(SCREE_MPI)
  add_test(NAME script.kill_ranks COMMAND /usr/bin/python3 -B ${CMAKE_SOURCE_DIR}/tests/python/kill.py $<TARGET_FILE:scree>
                                          ${CMAKE_CURRENT_BINARY_DIR}/kill_ranks 50 ${MPIEXEC_EXECUTABLE} 2)
  set_tests_properties(script.kill_ranks PROPERTIES LABELS long ENVIRONMENT OMP_WAIT_POLICY=passive)
endif()
