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
laws="-DSC_GROUP=128 -DSC_SEVERAL_RANKS=1 -DSC_CHOSEN_NORMAL=2 -DSC_CHOSEN_TANGENTIAL=6 -DSC_CHOSEN_ROLLING=1 -DSC_CHOSEN_TWISTING=1
      -DSC_CHOSEN_COHESION=2"
kernels=$(mktemp --suffix=.cl)
trap 'rm -f "$kernels"' EXIT
spheres="gathered faces spheres sort lists check"
for shaped in 0 1; do
  : > "$kernels"
  for text in $spheres $([ $shaped = 1 ] && echo pairs shape_walls shapes); do
    echo "#include \"scree/kernels/opencl/$text.cl\"" >> "$kernels"
  done
  for target in spir64 nvptx64; do
    check "kernels for $target, SC_SHAPED=$shaped" "$clang" $opencl -target $target -DSC_SHAPED=$shaped $laws -I"$source" \
          "$kernels"
  done
done
echo "$count headers"
[ "$count" -gt 0 ] && [ "$failed" -eq 0 ]
