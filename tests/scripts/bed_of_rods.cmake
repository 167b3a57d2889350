# How the example of rods and spheres finds the minimum fluidisation and the orientations.
add_test(NAME script.bed_of_rods COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/bed_of_rods_test.py)
set_tests_properties(script.bed_of_rods PROPERTIES LABELS quick)
