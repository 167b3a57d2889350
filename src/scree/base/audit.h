// Checks of the program against itself, kept in the builds that ask for them (presets audit and asan).
#pragma once

#include <cstdio>
#include <cstdlib>

namespace scree {

#ifdef SCREE_AUDIT
inline constexpr bool auditing = true;
#else
inline constexpr bool auditing = false;
#endif

/// Ends the program where something that must be true is not: a mistake of the programmer, never of the user.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "internal check failed: %s\n", what);
  std::abort();
}

}  // namespace scree
