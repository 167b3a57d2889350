# Usage: cmake -D SOURCE=DIR -D OUTPUT=FILE -P embed_kernels.cmake
# Writes src/scree/kernels/opencl/*.cl with all that they include, each header once, as two strings of C++, the second of what
# particles that are no spheres need besides: a device's compiler sees no files.
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

# Headers that only the second part includes are not in the first.
function(take_all part)
  set(text "")
  foreach(kernels ${ARGN})
    take("scree/kernels/opencl/${kernels}.cl")
  endforeach()
  set(seen "${seen}" PARENT_SCOPE)
  set(${part} "${text}" PARENT_SCOPE)
endfunction()

take_all(of_spheres gathered faces spheres sort lists check)
take_all(of_shapes pairs shape_walls shapes)
file(WRITE "${OUTPUT}" "#include \"scree/compute/opencl/text.h\"

const char* const scree::opencl::kernel_text = R\"kernels(${of_spheres})kernels\";
const char* const scree::opencl::shape_kernel_text = R\"kernels(${of_shapes})kernels\";
")
