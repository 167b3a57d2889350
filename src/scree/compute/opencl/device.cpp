#include "scree/compute/opencl/device.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scree/base/error.h"

namespace scree::opencl {
namespace {

void demand(cl_int code, const std::string& what) {
  if (code != CL_SUCCESS) throw ResourceError(fmt::format("the OpenCL device cannot {} (error {})", what, code));
}

std::string text_of(cl_device_id id, cl_device_info what) {
  std::size_t size = 0;
  if (library().clGetDeviceInfo(id, what, 0, nullptr, &size) != CL_SUCCESS || size == 0) return {};
  std::string text(size, '\0');
  library().clGetDeviceInfo(id, what, size, text.data(), nullptr);
  text.resize(size - 1);
  return text;
}

template <class T>
T number_of(cl_device_id id, cl_device_info what) {
  T value{};
  library().clGetDeviceInfo(id, what, sizeof value, &value, nullptr);
  return value;
}

std::string platform_name(cl_platform_id id) {
  char name[256] = "";
  library().clGetPlatformInfo(id, CL_PLATFORM_NAME, sizeof name - 1, name, nullptr);
  return name;
}

DeviceInfo info_of(cl_platform_id platform, cl_device_id id) {
  DeviceInfo info;
  info.name = text_of(id, CL_DEVICE_NAME);
  info.platform = platform_name(platform);
  info.version = text_of(id, CL_DEVICE_VERSION);
  info.driver = text_of(id, CL_DRIVER_VERSION);
  info.memory = static_cast<double>(number_of<cl_ulong>(id, CL_DEVICE_GLOBAL_MEM_SIZE));
  info.fp64 = text_of(id, CL_DEVICE_EXTENSIONS).find("cl_khr_fp64") != std::string::npos;
  info.gpu = number_of<cl_device_type>(id, CL_DEVICE_TYPE) & CL_DEVICE_TYPE_GPU;
  info.platform_id = platform;
  info.id = id;
  return info;
}

}  // namespace

std::vector<DeviceInfo> devices() {
  const Library& lib = library();
  std::vector<DeviceInfo> out;
  if (!lib.found) return out;
  cl_uint count = 0;
  lib.clGetPlatformIDs(0, nullptr, &count);
  std::vector<cl_platform_id> platforms(count);
  lib.clGetPlatformIDs(count, platforms.data(), nullptr);
  for (const cl_platform_id platform : platforms) {
    cl_uint found = 0;
    if (lib.clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &found) != CL_SUCCESS) continue;
    std::vector<cl_device_id> ids(found);
    lib.clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, found, ids.data(), nullptr);
    for (const cl_device_id id : ids) out.push_back(info_of(platform, id));
  }
  std::stable_partition(out.begin(), out.end(), [](const DeviceInfo& d) { return d.gpu; });
  return out;
}

Device::Device(const DeviceInfo& info)
    : info_(info), context_(nullptr, library().clReleaseContext), queue_(nullptr, library().clReleaseCommandQueue) {
  cl_int code = CL_SUCCESS;
  const cl_context_properties properties[] = {CL_CONTEXT_PLATFORM,
                                              reinterpret_cast<cl_context_properties>(info.platform_id), 0};
  context_.reset(library().clCreateContext(properties, 1, &info.id, nullptr, nullptr, &code));
  demand(code, fmt::format("be opened: {}", info.name));
  queue_.reset(library().clCreateCommandQueue(context_.get(), info.id, 0, &code));
  demand(code, fmt::format("take commands: {}", info.name));
}

void Device::finish() const { demand(library().clFinish(queue_.get()), "finish its work"); }

DeviceBuffer::DeviceBuffer(const Device& device, std::size_t bytes)
    : device_(&device), bytes_((bytes + sizeof(cl_uint) - 1) / sizeof(cl_uint) * sizeof(cl_uint)) {
  if (bytes == 0) return;
  cl_int code = CL_SUCCESS;
  memory_ = library().clCreateBuffer(device.context(), CL_MEM_READ_WRITE, bytes_, nullptr, &code);
  demand(code, fmt::format("give {:.3g} MB of memory; it has {:.3g} MB in all", static_cast<double>(bytes) / 1e6,
                           device.info().memory / 1e6));
  clear();
}

DeviceBuffer::~DeviceBuffer() {
  if (memory_) library().clReleaseMemObject(memory_);
}

void DeviceBuffer::swap(DeviceBuffer& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(memory_, other.memory_);
  std::swap(bytes_, other.bytes_);
}

void DeviceBuffer::write(const void* from, std::size_t bytes, std::size_t offset) {
  if (bytes == 0) return;
  demand(library().clEnqueueWriteBuffer(device_->queue(), memory_, CL_TRUE, offset, bytes, from, 0, nullptr, nullptr),
         "be written to");
}

void DeviceBuffer::read(void* to, std::size_t bytes, std::size_t offset) const {
  if (bytes == 0) return;
  demand(library().clEnqueueReadBuffer(device_->queue(), memory_, CL_TRUE, offset, bytes, to, 0, nullptr, nullptr),
         "be read from");
}

void DeviceBuffer::clear() {
  // In pieces, since drivers count the patterns of one command in 32 bits.
  constexpr std::size_t piece = std::size_t{1} << 30;
  const cl_uint zero = 0;
  for (std::size_t from = 0; from < bytes_; from += piece)
    demand(library().clEnqueueFillBuffer(device_->queue(), memory_, &zero, sizeof zero, from,
                                         std::min(piece, bytes_ - from), 0, nullptr, nullptr),
           "clear memory");
}

void DeviceBuffer::copy_from(const DeviceBuffer& other, std::size_t bytes, std::size_t offset) {
  if (bytes == 0) return;
  demand(library().clEnqueueCopyBuffer(device_->queue(), other.memory_, memory_, 0, offset, bytes, 0, nullptr, nullptr),
         "copy memory");
}

Program::Program(const Device& device, const std::string& text, const std::string& options)
    : device_(device), program_(nullptr, library().clReleaseProgram) {
  const Library& lib = library();
  const char* source = text.c_str();
  cl_int code = CL_SUCCESS;
  program_.reset(lib.clCreateProgramWithSource(device.context(), 1, &source, nullptr, &code));
  demand(code, "take a program");
  const cl_device_id id = device.info().id;
  code = lib.clBuildProgram(program_.get(), 1, &id, options.c_str(), nullptr, nullptr);
  if (code == CL_SUCCESS) return;
  std::size_t size = 0;
  lib.clGetProgramBuildInfo(program_.get(), id, CL_PROGRAM_BUILD_LOG, 0, nullptr, &size);
  std::string log(size, '\0');
  lib.clGetProgramBuildInfo(program_.get(), id, CL_PROGRAM_BUILD_LOG, size, log.data(), nullptr);
  throw ResourceError(fmt::format("{} ({}) cannot compile the kernels (error {})\noptions: {}\n{}", device.info().name,
                                  device.info().version, code, options, log));
}

cl_kernel Program::kernel_of(const char* name) {
  for (const Named& k : kernels_)
    if (k.name == name) return k.kernel.get();
  cl_int code = CL_SUCCESS;
  const cl_kernel kernel = library().clCreateKernel(program_.get(), name, &code);
  demand(code, fmt::format("find the kernel {}", name));
  kernels_.push_back({name, {kernel, library().clReleaseKernel}});
  return kernel;
}

void Program::set(cl_kernel kernel, cl_uint place, const DeviceBuffer& buffer) {
  const cl_mem memory = buffer.memory();
  set_bytes(kernel, place, sizeof memory, &memory);
}

void Program::set_bytes(cl_kernel kernel, cl_uint place, std::size_t size, const void* value) {
  demand(library().clSetKernelArg(kernel, place, size, value), fmt::format("take argument {} of a kernel", place));
}

void Program::enqueue(const char* name, cl_kernel kernel, std::size_t count, std::size_t group) const {
  if (count == 0) return;
  const std::size_t items = (count + group - 1) / group * group;
  demand(library().clEnqueueNDRangeKernel(device_.queue(), kernel, 1, nullptr, &items, &group, 0, nullptr, nullptr),
         fmt::format("run the kernel {}", name));
}

}  // namespace scree::opencl
