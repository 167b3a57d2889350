#!/bin/sh
# contraction.sh OBJDUMP OBJECT...: fails if a compiled pass multiplies and adds with one rounding.
objdump=$1
shift
found=$("$objdump" -d --demangle --no-show-raw-insn "$@" |
  awk '/^[0-9a-f]+ </ { name = $0 } /vfn?m(add|sub)/ { if (!seen[name]++) print name }')
[ -z "$found" ] || { printf 'fused multiply-add in\n%s\n' "$found"; exit 1; }
