# Particles in a fluid that is solved for, as runs: restarts, several processes, threads.
if(SCREE_MPI AND SCREE_HYPRE)
  add_test(NAME script.coupled COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/coupled_test.py $<TARGET_FILE:scree>
                                       ${MPIEXEC_EXECUTABLE})
  set_tests_properties(script.coupled PROPERTIES LABELS quick ENVIRONMENT OMP_WAIT_POLICY=passive)
endif()
