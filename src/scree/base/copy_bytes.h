// Copying memory of which there may be none.
#pragma once

#include <cstddef>
#include <cstring>

namespace scree {

/// As memcpy, which must not be given null pointers, not even for no bytes: those of empty vectors may be.
inline void copy_bytes(void* to, const void* from, std::size_t size) {
  if (size > 0) std::memcpy(to, from, size);
}

}  // namespace scree
