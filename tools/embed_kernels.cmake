# Usage: cmake -D SOURCE=DIR -D OUTPUT=FILE -P embed_kernels.cmake
# Writes src/scree/kernels/opencl/*.cl with all that they include, each header once, as strings of C++: a device's compiler
# sees no files. What particles that are no spheres need besides are texts of their own, which follow the first: one for both
# precisions begins, one says how their state is kept in either, and one for both has the kernels. Mixed precision needs the
# text of contacts twice, in single and in double precision: the former is the same text with names that begin with sf_ instead
# of sc_. Where OUTPUT ends in .cl, the text of mixed precision is written as it is, where in .shapes.cl that of shapes, in
# .mixed_shapes.cl that of shapes in mixed precision.
cmake_minimum_required(VERSION 3.25)

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

function(flatten result)
  set(seen "")
  set(text "")
  foreach(kernels ${ARGN})
    take("scree/kernels/opencl/${kernels}.cl")
  endforeach()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# What `longer` has more than `shorter`, with which it begins: headers that both include are in the first.
function(rest_of result longer shorter)
  string(LENGTH "${shorter}" length)
  string(SUBSTRING "${longer}" ${length} -1 rest)
  set(${result} "${rest}" PARENT_SCOPE)
endfunction()

set(of_spheres state gathered partners faces fields spheres prescribed planes sort lists carry check try_law)
set(of_shapes pairs shape_walls shapes)
flatten(double ${of_spheres})
flatten(mixed_state ${of_spheres} mixed)
flatten(begun ${of_spheres} bodies)
flatten(full_state ${of_spheres} bodies full_bodies)
flatten(all ${of_spheres} bodies full_bodies ${of_shapes})
rest_of(mixed "${mixed_state}" "${double}")
rest_of(bodies "${begun}" "${double}")
rest_of(full_bodies "${full_state}" "${begun}")
rest_of(shapes "${all}" "${full_state}")
flatten(mixed_bodies mixed_bodies)
flatten(single fixed_point gathered partners pair_contacts carry try_law)
foreach(prefix sc_:sf_ SC_:SF_ SCREE_:SCREE_SINGLE_)
  string(REPLACE ":" ";" pair ${prefix})
  list(GET pair 0 from)
  list(GET pair 1 to)
  string(REPLACE "${from}" "${to}" single "${single}")
endforeach()
string(PREPEND single "#define SCREE_SINGLE_FLOAT\n#define real sf_real\n#define real4 sf_real4\n")
string(APPEND single "#undef real\n#undef real4\n")
if(OUTPUT MATCHES "\\.mixed_shapes\\.cl$")
  file(WRITE "${OUTPUT}" "${single}${double}${mixed}${bodies}${mixed_bodies}${shapes}")
  return()
elseif(OUTPUT MATCHES "\\.shapes\\.cl$")
  file(WRITE "${OUTPUT}" "${all}")
  return()
elseif(OUTPUT MATCHES "\\.cl$")
  file(WRITE "${OUTPUT}" "${single}${double}${mixed}")
  return()
endif()
file(WRITE "${OUTPUT}" "#include \"scree/compute/opencl/text.h\"

const char* const scree::opencl::kernel_text = R\"kernels(${double})kernels\";
const char* const scree::opencl::bodies_text = R\"kernels(${bodies})kernels\";
const char* const scree::opencl::full_bodies_text = R\"kernels(${full_bodies})kernels\";
const char* const scree::opencl::mixed_bodies_text = R\"kernels(${mixed_bodies})kernels\";
const char* const scree::opencl::shape_kernel_text = R\"kernels(${shapes})kernels\";
const char* const scree::opencl::single_text = R\"kernels(${single})kernels\";
const char* const scree::opencl::mixed_text = R\"kernels(${mixed})kernels\";
")
