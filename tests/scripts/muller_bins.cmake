# How the validation with Müller's bed measures volumes in bins.
add_test(NAME script.muller_bins COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/muller_bins_test.py)
set_tests_properties(script.muller_bins PROPERTIES LABELS quick)
