# Commands, options and exit codes as a user meets them.
add_test(NAME script.command_line COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/command_line_test.py
                                          $<TARGET_FILE:scree>)
set_tests_properties(script.command_line PROPERTIES LABELS quick ENVIRONMENT OMP_WAIT_POLICY=passive)
