# Kernels for devices under a simulator that sees races, barriers that not all reach, and what lies beyond buffers.
find_file(OCLGRIND liboclgrind-rt-icd.so PATHS /usr/lib/oclgrind /usr/lib/x86_64-linux-gnu/oclgrind)
if(OCLGRIND)
  add_test(NAME script.device COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/device_test.py $<TARGET_FILE:scree>
                                      ${OCLGRIND} $<BOOL:${SCREE_HYPRE}>)
  set_tests_properties(script.device PROPERTIES LABELS quick ENVIRONMENT OMP_WAIT_POLICY=passive)
else()
  message(WARNING "Oclgrind was not found: races of the kernels for devices are not looked for")
endif()
