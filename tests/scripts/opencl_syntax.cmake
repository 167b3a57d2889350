# Every header of physics/ and kernels/ compiles alone: as OpenCL C 1.2 in double and in float (clang's syntax check, no
# device needed) and as C++ in both.
find_program(CLANG NAMES clang clang-14 clang-15 clang-16)
if(CLANG)
  add_test(NAME opencl_syntax
           COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/scripts/opencl_syntax.sh ${CMAKE_SOURCE_DIR}/src ${CLANG}
                   ${CMAKE_CXX_COMPILER})
  set_tests_properties(opencl_syntax PROPERTIES LABELS quick)
else()
  message(WARNING "clang was not found: the headers are not checked as OpenCL C")
endif()
