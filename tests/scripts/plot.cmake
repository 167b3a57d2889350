# The pictures of a made-up run, and the drawing of spheres against brute force.
add_test(NAME script.plot COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/plot_test.py ${CMAKE_SOURCE_DIR}/share)
set_tests_properties(script.plot PROPERTIES LABELS quick)
