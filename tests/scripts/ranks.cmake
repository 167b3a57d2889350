# Runs on several processes: the same results for any number of them, restarts on another number, one message for what
# goes wrong; a contact of two of them by vertices; files that they write at once, and disks that are full; particles that go
# far, are wider than blocks, or are lost; devices of several processes; ten thousand steps.
if(SCREE_MPI)
  foreach(name ranks ranks_contact ranks_device ranks_files ranks_lost ranks_long)
    add_test(NAME script.${name} COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/${name}_test.py
                                         $<TARGET_FILE:scree> ${MPIEXEC_EXECUTABLE})
    set_tests_properties(script.${name} PROPERTIES LABELS quick ENVIRONMENT OMP_WAIT_POLICY=passive)
  endforeach()
  set_tests_properties(script.ranks_long PROPERTIES LABELS long TIMEOUT 3600)
endif()
