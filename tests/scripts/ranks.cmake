# Runs on several processes: the same results for any number of them, restarts on another number, one message for what
# goes wrong.
if(SCREE_MPI)
  add_test(NAME script.ranks COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/ranks_test.py $<TARGET_FILE:scree>
                                     ${MPIEXEC_EXECUTABLE})
  set_tests_properties(script.ranks PROPERTIES LABELS quick ENVIRONMENT OMP_WAIT_POLICY=passive)
endif()
