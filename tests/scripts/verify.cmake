# The verification book as a whole: every number of every case.
add_test(NAME script.verify COMMAND scree verify -o ${CMAKE_CURRENT_BINARY_DIR}/verification)
set_tests_properties(script.verify PROPERTIES LABELS long TIMEOUT 3000)
