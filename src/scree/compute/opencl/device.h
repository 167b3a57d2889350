// A device, its memory, and kernels that run on it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "scree/compute/opencl/library.h"

namespace scree::opencl {

/// What `scree info` says of a device; its place in the list is its number.
struct DeviceInfo {
  std::string name, platform, version, driver;
  double memory = 0;  // [bytes]
  bool fp64 = false;  // has double precision
  bool gpu = false;
  cl_platform_id platform_id = nullptr;
  cl_device_id id = nullptr;
};

/// All devices of all platforms, GPUs first. Empty without a library.
std::vector<DeviceInfo> devices();

/// A device in use: commands run in the order in which they are given.
class Device {
 public:
  /// Throws ResourceError if it cannot be used.
  explicit Device(const DeviceInfo& info);

  const DeviceInfo& info() const { return info_; }
  cl_context context() const { return context_.get(); }
  cl_command_queue queue() const { return queue_.get(); }

  /// Waits until all commands are done. Throws ResourceError if one failed.
  void finish() const;

 private:
  DeviceInfo info_;
  std::unique_ptr<std::remove_pointer_t<cl_context>, cl_int (*)(cl_context)> context_;
  std::unique_ptr<std::remove_pointer_t<cl_command_queue>, cl_int (*)(cl_command_queue)> queue_;
};

/// Memory of a device.
class DeviceBuffer {
 public:
  DeviceBuffer() = default;
  /// Zero bytes give an empty buffer; the others begin as zeros. Throws ResourceError if memory is refused.
  DeviceBuffer(const Device& device, std::size_t bytes);
  DeviceBuffer(DeviceBuffer&& other) noexcept { swap(other); }
  DeviceBuffer& operator=(DeviceBuffer&& other) noexcept {
    swap(other);
    return *this;
  }
  DeviceBuffer(const DeviceBuffer&) = delete;
  DeviceBuffer& operator=(const DeviceBuffer&) = delete;
  ~DeviceBuffer();

  std::size_t bytes() const { return bytes_; }
  cl_mem memory() const { return memory_; }
  void swap(DeviceBuffer& other) noexcept;

  /// Copies; reading waits until it is done.
  void write(const void* from, std::size_t bytes, std::size_t offset = 0);
  void read(void* to, std::size_t bytes, std::size_t offset = 0) const;
  void clear();
  void copy_from(const DeviceBuffer& other, std::size_t bytes, std::size_t offset = 0);

  template <class T>
  std::vector<T> values(std::size_t count) const {
    std::vector<T> out(count);
    if (count > 0) read(out.data(), count * sizeof(T));
    return out;
  }

 private:
  const Device* device_ = nullptr;
  cl_mem memory_ = nullptr;
  std::size_t bytes_ = 0;
};

/// Memory of a device that holds some values.
template <class T>
DeviceBuffer sent(const Device& device, const std::vector<T>& values) {
  DeviceBuffer buffer(device, values.size() * sizeof(T));
  buffer.write(values.data(), values.size() * sizeof(T));
  return buffer;
}

/// Compiled kernels.
class Program {
 public:
  /// Compiles OpenCL C. Throws ResourceError with the options and the compiler's log if that fails.
  Program(const Device& device, const std::string& text, const std::string& options);

  /// Runs a kernel once for each of `count` items, in groups of `group`; the kernel has to leave out what is beyond
  /// the count. Arguments are buffers, and plain values with the types that the kernel declares.
  template <class... Arguments>
  void run(const char* kernel, std::size_t count, std::size_t group, const Arguments&... arguments) {
    const cl_kernel k = kernel_of(kernel);
    cl_uint place = 0;
    (set(k, place++, arguments), ...);
    enqueue(kernel, k, count, group);
  }

 private:
  cl_kernel kernel_of(const char* name);
  void enqueue(const char* name, cl_kernel kernel, std::size_t count, std::size_t group) const;
  static void set(cl_kernel kernel, cl_uint place, const DeviceBuffer& buffer);
  static void set_bytes(cl_kernel kernel, cl_uint place, std::size_t size, const void* value);
  template <class T>
  static void set(cl_kernel kernel, cl_uint place, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    set_bytes(kernel, place, sizeof value, &value);
  }

  struct Named {
    std::string name;
    std::unique_ptr<std::remove_pointer_t<cl_kernel>, cl_int (*)(cl_kernel)> kernel;
  };

  const Device& device_;
  std::unique_ptr<std::remove_pointer_t<cl_program>, cl_int (*)(cl_program)> program_;
  std::vector<Named> kernels_;
};

}  // namespace scree::opencl
