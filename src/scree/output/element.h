// The element types that files hold, and an array of them as the files see it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace scree {

enum class Element : std::uint8_t { float64, float32, int32, int64, uint8, uint32, uint64 };

/// Size of one element [bytes].
constexpr std::size_t element_size(Element element) {
  switch (element) {
    case Element::float64:
    case Element::int64:
    case Element::uint64:
      return 8;
    case Element::float32:
    case Element::int32:
    case Element::uint32:
      return 4;
    case Element::uint8:
      return 1;
  }
  return 0;
}

/// The name that messages use.
constexpr std::string_view element_name(Element element) {
  constexpr std::string_view names[] = {"float64", "float32", "int32", "int64", "uint8", "uint32", "uint64"};
  return names[static_cast<std::size_t>(element)];
}

constexpr bool is_floating(Element element) { return element == Element::float64 || element == Element::float32; }

/// The element type of a C++ type.
template <class T>
constexpr Element element_of() {
  if constexpr (std::is_same_v<T, double>)
    return Element::float64;
  else if constexpr (std::is_same_v<T, float>)
    return Element::float32;
  else if constexpr (std::is_same_v<T, std::int32_t>)
    return Element::int32;
  else if constexpr (std::is_same_v<T, std::int64_t>)
    return Element::int64;
  else if constexpr (std::is_same_v<T, std::uint8_t>)
    return Element::uint8;
  else if constexpr (std::is_same_v<T, std::uint32_t>)
    return Element::uint32;
  else {
    static_assert(std::is_same_v<T, std::uint64_t>, "files hold no elements of this type");
    return Element::uint64;
  }
}

/// Values that belong to somebody else: `rows` rows of `columns` elements, row by row.
struct ArrayView {
  Element element = Element::float64;
  std::uint64_t rows = 0, columns = 1;
  const void* data = nullptr;

  std::uint64_t bytes() const { return rows * columns * element_size(element); }
};

template <class T>
ArrayView array_view(const T* data, std::uint64_t rows, std::uint64_t columns = 1) {
  return {element_of<T>(), rows, columns, data};
}

}  // namespace scree
