// Memory of the CPU back end: contiguous, aligned for the widest vector, on huge pages where the system offers them.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>

namespace scree {

/// A resizable array of plain values; elements that resize() adds are zero.
/// Throws std::bad_alloc when memory is refused.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>, "a buffer holds plain values");

 public:
  Buffer() = default;
  explicit Buffer(std::size_t n) { resize(n); }
  Buffer(const Buffer& other) {
    resize(other.size_);
    std::copy_n(other.data_, other.size_, data_);
  }
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer other) noexcept {
    swap(other);
    return *this;
  }
  ~Buffer() { std::free(data_); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }

  void resize(std::size_t n) {
    if (n > capacity_) reserve(std::max(n, capacity_ + capacity_ / 4));
    if (n > size_) std::fill(data_ + size_, data_ + n, T{});
    size_ = n;
  }

  void swap(Buffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  static constexpr std::size_t alignment = 64;
  static constexpr std::size_t huge_page = std::size_t{2} << 20;
  static constexpr std::size_t large = huge_page / 4;  // worth a huge page that it does not fill

  void reserve(std::size_t n) {
    const std::size_t bytes = n * sizeof(T);
    const std::size_t align = bytes >= large ? huge_page : alignment;
    const std::size_t rounded = (bytes + align - 1) / align * align;
    void* memory = std::aligned_alloc(align, rounded);
    if (!memory) throw std::bad_alloc();
    // A sweep touches hundreds of pages per microsecond; with 4 kB pages the address translation costs a tenth of it.
    if (align == huge_page) madvise(memory, rounded, MADV_HUGEPAGE);
    if (size_) std::copy_n(data_, size_, static_cast<T*>(memory));
    std::free(data_);
    data_ = static_cast<T*>(memory);
    capacity_ = n;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace scree
