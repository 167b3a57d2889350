# Runs on several processes: the same results for any number of them, restarts on another number, one message for what
# goes wrong.
# Files that they write at once, and disks that are full.
if(SCREE_MPI)
  foreach(name ranks ranks_files)
    add_test(NAME script.${name} COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/${name}_test.py
                                         $<TARGET_FILE:scree> ${MPIEXEC_EXECUTABLE})
    set_tests_properties(script.${name} PROPERTIES LABELS quick ENVIRONMENT OMP_WAIT_POLICY=passive)
  endforeach()
endif()
