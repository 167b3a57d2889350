# Checks of the source tree itself, and of what comes with the program.
set(python /usr/bin/python3 -B)
set(tools ${CMAKE_SOURCE_DIR}/tools)

add_test(NAME house.includes COMMAND ${python} ${tools}/check_includes.py ${CMAKE_SOURCE_DIR})
add_test(NAME house.files COMMAND ${python} ${tools}/check_files.py ${CMAKE_SOURCE_DIR})
add_test(NAME house.architecture COMMAND ${python} ${tools}/check_architecture.py ${CMAKE_SOURCE_DIR})
add_test(NAME house.sources COMMAND ${python} ${tools}/check_sources.py ${CMAKE_SOURCE_DIR} $<TARGET_FILE:scree>)
add_test(NAME house.checks_bite COMMAND ${python} ${CMAKE_CURRENT_LIST_DIR}/house_test.py ${tools})
set_tests_properties(house.includes house.files house.architecture house.sources house.checks_bite
                     PROPERTIES LABELS quick)

# Other versions of clang-format lay the same text out in other ways.
find_program(CLANG_FORMAT NAMES clang-format-14 clang-format)
if(CLANG_FORMAT)
  execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE clang_format_version)
endif()
if(clang_format_version MATCHES "version 14\\.")
  add_test(NAME house.format COMMAND ${CMAKE_CURRENT_LIST_DIR}/format.sh ${CLANG_FORMAT} ${CMAKE_SOURCE_DIR})
  set_tests_properties(house.format PROPERTIES LABELS quick)
else()
  message(WARNING "clang-format 14 was not found: the layout of the sources is not checked")
endif()

# Every example runs for some steps, every case passes `scree check`; an installed tree works from any prefix.
add_test(NAME cases.check COMMAND ${python} ${CMAKE_CURRENT_LIST_DIR}/cases_test.py $<TARGET_FILE:scree>
                                  ${CMAKE_SOURCE_DIR})
add_test(NAME install.works COMMAND ${python} ${CMAKE_CURRENT_LIST_DIR}/install_test.py ${CMAKE_COMMAND}
                                    ${CMAKE_BINARY_DIR} ${CMAKE_INSTALL_BINDIR})
set_tests_properties(cases.check install.works PROPERTIES LABELS normal)
