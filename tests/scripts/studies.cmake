# The scripts of docs/studies/, with runs of no length: that they work, not what they find.
add_test(NAME script.studies COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_LIST_DIR}/studies_test.py $<TARGET_FILE:scree>
         ${CMAKE_SOURCE_DIR}/docs/studies)
set_tests_properties(script.studies PROPERTIES LABELS normal)
