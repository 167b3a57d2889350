#!/bin/sh
# Usage: format.sh CLANG_FORMAT SOURCE_DIR. Fails and names the places where a source file is not laid out as .clang-format says.
cd "$2" && find src tests bench -name '*.h' -o -name '*.cpp' | sort | xargs "$1" --dry-run -Werror
