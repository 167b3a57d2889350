# Usage: cmake -D SOURCE=DIR -D OUTPUT=FILE -P embed_kernels.cmake
# Writes src/scree/kernels/opencl/*.cl with all that they include, each header once, as one string of C++: a device's
# compiler sees no files.
cmake_minimum_required(VERSION 3.25)
set(seen "")
set(text "")

function(take file)
  if(file IN_LIST seen)
    return()
  endif()
  list(APPEND seen "${file}")
  file(READ "${SOURCE}/${file}" left)
  while(left MATCHES "#include \"([^\"]+)\"\n")
    set(included "${CMAKE_MATCH_1}")
    string(FIND "${left}" "#include \"${included}\"\n" at)
    string(SUBSTRING "${left}" 0 ${at} before)
    string(LENGTH "#include \"${included}\"\n" length)
    math(EXPR at "${at} + ${length}")
    string(SUBSTRING "${left}" ${at} -1 left)
    string(APPEND text "${before}")
    take("${included}")
  endwhile()
  string(APPEND text "${left}")
  set(seen "${seen}" PARENT_SCOPE)
  set(text "${text}" PARENT_SCOPE)
endfunction()

foreach(kernels gathered faces fields spheres sort lists check)
  take("scree/kernels/opencl/${kernels}.cl")
endforeach()
file(WRITE "${OUTPUT}" "#include \"scree/compute/opencl/text.h\"

const char* const scree::opencl::kernel_text = R\"kernels(${text})kernels\";
")
