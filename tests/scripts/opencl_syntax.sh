#!/bin/sh
# Usage: opencl_syntax.sh SOURCE_DIR CLANG CXX
# Compiles every header of physics/ and kernels/ alone, in every language and precision, and the kernels of devices for two
# kinds of them; fails with the first messages.
set -u
source=$1 clang=$2 cxx=$3
failed=0

check() {
  what=$1
  shift
  if ! messages=$("$@" 2>&1); then
    echo "$what"
    echo "$messages" | head -20
    failed=1
  fi
}

# __OPENCL_VERSION__ is what a device's compiler defines; -Wno-unused-function: a header alone calls none of its own.
opencl="-x cl -cl-std=CL1.2 -D__OPENCL_VERSION__=120 -Xclang -finclude-default-header -target spir64 -fsyntax-only
        -Wall -Wextra -Werror -Wno-unused-function -Wno-pragma-once-outside-header"
cplusplus="-x c++ -std=c++20 -fsyntax-only -Wall -Wextra -Wshadow"
# Conditions joined by & are meant, as in CMakeLists.txt.
case $("$cxx" --version) in
  *clang*) cplusplus="$cplusplus -Wno-pragma-once-outside-header -Wno-bitwise-instead-of-logical" ;;
esac

count=0
for header in $(find "$source/scree/physics" "$source/scree/kernels" -name '*.h' | sort); do
  count=$((count + 1))
  check "$header as OpenCL C, double" "$clang" $opencl -I"$source" "$header"
  check "$header as OpenCL C, float" "$clang" $opencl -DSCREE_FLOAT -Wdouble-promotion -I"$source" "$header"
  check "$header as C++" "$cxx" $cplusplus -Werror -I"$source" "$header"
  check "$header as C++, float" "$cxx" $cplusplus -Werror -DSCREE_FLOAT -Wdouble-promotion -I"$source" "$header"
done
laws=
for prefix in SC SF; do
  laws="$laws -D${prefix}_GROUP=128 -D${prefix}_SHAPED=0 -D${prefix}_CHOSEN_NORMAL=2 -D${prefix}_CHOSEN_TANGENTIAL=6 -D${prefix}_CHOSEN_ROLLING=1
        -D${prefix}_CHOSEN_TWISTING=1 -D${prefix}_CHOSEN_COHESION=2"
done
formulas=""
for component in X Y Z; do
  formulas="$formulas -DSC_FORMULA_ACCELERATION_$component=sc_formula_sin(x+y)*z*t"
  formulas="$formulas -DSC_FORMULA_VELOCITY_$component=sc_formula_power(x,y)*z*t"
done
# All that a prescribed flow does, by formulas, found by a kernel of its own; a fluid that is solved for; one that turns bodies.
everything="-DSC_CHOSEN_FIELDS=2 -DSC_CHOSEN_BODY_FORCE=3 -DSC_CHOSEN_FLOW=4 -DSC_CHOSEN_DRAG=100 -DSC_CHOSEN_BUOYANCY=1
            -DSC_CHOSEN_WATCHED=1 -DSC_CHOSEN_COUPLED=0 -DSC_CHOSEN_PUSHES=1 -DSC_CHOSEN_TURNS=1 -DSC_CHOSEN_FORCE_DRAG=0
            -DSC_CHOSEN_BODY_DRAG=13 -DSC_CHOSEN_LIFT=1 -DSC_CHOSEN_PITCHING=1 -DSC_CHOSEN_VISCOUS_TURN=1
            -DSC_CHOSEN_SAFFMAN=1 -DSC_CHOSEN_MAGNUS=1 -DSC_CHOSEN_CARRIED=1 -DSC_CHOSEN_ADDED_MASS=1"
solved="-DSC_CHOSEN_FIELDS=1 -DSC_CHOSEN_BODY_FORCE=1 -DSC_CHOSEN_FLOW=0 -DSC_CHOSEN_DRAG=100 -DSC_CHOSEN_BUOYANCY=0
        -DSC_CHOSEN_WATCHED=0 -DSC_CHOSEN_COUPLED=1 -DSC_CHOSEN_PUSHES=0 -DSC_CHOSEN_TURNS=0 -DSC_CHOSEN_FORCE_DRAG=5
        -DSC_CHOSEN_BODY_DRAG=0 -DSC_CHOSEN_LIFT=0 -DSC_CHOSEN_PITCHING=0 -DSC_CHOSEN_VISCOUS_TURN=0
        -DSC_CHOSEN_SAFFMAN=0 -DSC_CHOSEN_MAGNUS=0 -DSC_CHOSEN_CARRIED=0 -DSC_CHOSEN_ADDED_MASS=0"
turned=$(echo "$solved" | sed 's/FIELDS=1/FIELDS=2/; s/TURNS=0/TURNS=1/; s/BODY_DRAG=0/BODY_DRAG=13/; s/PITCHING=0/PITCHING=1/; s/VISCOUS_TURN=0/VISCOUS_TURN=1/')
kernels=$(mktemp -d)
trap 'rm -rf "$kernels"' EXIT
for text in state gathered partners faces fields spheres prescribed planes sort lists carry check try_law; do
  echo "#include \"scree/kernels/opencl/$text.cl\"" >> "$kernels/double.cl"
done
check "text in mixed precision" cmake -D SOURCE="$source" -D OUTPUT="$kernels/mixed.cl" -P "$source/../tools/embed_kernels.cmake"
check "text of shapes in mixed precision" cmake -D SOURCE="$source" -D OUTPUT="$kernels/all.mixed_shapes.cl" -P "$source/../tools/embed_kernels.cmake"
check "text of shapes" cmake -D SOURCE="$source" -D OUTPUT="$kernels/all.shapes.cl" -P "$source/../tools/embed_kernels.cmake"
for target in spir64 nvptx64; do
  for fields in "$everything" "$solved" "$turned"; do
    check "kernels for $target" "$clang" $opencl -target $target -DSC_SEVERAL_RANKS=1 $laws $fields $formulas -I"$source" "$kernels/double.cl"
  done
  for fields in "$everything" "$solved" "$turned"; do
    check "kernels of shapes for $target" "$clang" $opencl -target $target -DSC_SEVERAL_RANKS=1 $laws -USC_SHAPED -DSC_SHAPED=1 $fields $formulas "$kernels/all.shapes.cl"
    check "kernels of shapes in mixed precision for $target" "$clang" $opencl -target $target -DSC_SEVERAL_RANKS=0 $laws -USC_SHAPED -DSC_SHAPED=1 -USF_SHAPED -DSF_SHAPED=1 $fields $formulas "$kernels/all.mixed_shapes.cl"
  done
  check "kernels in mixed precision for $target" "$clang" $opencl -target $target -DSC_SEVERAL_RANKS=0 $laws $solved $formulas "$kernels/mixed.cl"
done
for text in fixed_point gathered partners pair_contacts carry try_law; do
  echo "#include \"scree/kernels/opencl/$text.cl\"" >> "$kernels/single.cl"
done
check "kernels in single precision" "$clang" $opencl -DSCREE_FLOAT -Wdouble-promotion $laws -I"$source" "$kernels/single.cl"
echo "$count headers"
[ "$count" -gt 0 ] && [ "$failed" -eq 0 ]
