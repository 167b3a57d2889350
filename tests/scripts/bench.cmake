# The benchmark of run time over the number of particles, in its two smallest sizes: that it works, not how fast.
add_test(NAME script.bench COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/bench_test.py $<TARGET_FILE:scree>
         ${CMAKE_SOURCE_DIR}/share)
set_tests_properties(script.bench PROPERTIES LABELS quick)
