#include "scree/compute/opencl/library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

namespace scree::opencl {
namespace {

/// Names of the loader; the plain one comes with development packages only.
constexpr const char* loaders[] = {"libOpenCL.so.1", "libOpenCL.so"};

/// NVIDIA's library where it is mounted into containers.
constexpr const char* vendors[] = {"/usr/lib/x86_64-linux-gnu/libnvidia-opencl.so.1",
                                   "/usr/local/nvidia/lib64/libnvidia-opencl.so.1", "/usr/lib64/libnvidia-opencl.so.1",
                                   "/usr/lib/libnvidia-opencl.so.1", "/usr/lib/wsl/lib/libnvidia-opencl.so.1"};

/// The variable by which loaders are told where vendors' libraries are.
constexpr const char* vendors_variable = "OCL_ICD_VENDORS";

/// True if all functions are there.
bool take_functions(void* handle, Library& lib) {
  bool all = true;
#define FUNCTION(name)                                                   \
  lib.name = reinterpret_cast<decltype(lib.name)>(dlsym(handle, #name)); \
  all = all && lib.name;
  SCREE_OPENCL_FUNCTIONS(FUNCTION)
#undef FUNCTION
  return all;
}

bool knows_platforms(const Library& lib) {
  cl_uint count = 0;
  return lib.clGetPlatformIDs(0, nullptr, &count) == CL_SUCCESS && count > 0;
}

/// A loader reads the list of vendors at its first call, so it is to be told before it is loaded.
void name_vendor(Library& lib) {
  std::error_code ignored;
  const std::filesystem::path lists = "/etc/OpenCL/vendors";
  const bool listed = std::filesystem::is_directory(lists, ignored) && !std::filesystem::is_empty(lists, ignored);
  if (std::getenv(vendors_variable) || listed) return;
  for (const char* path : vendors) {
    if (!std::filesystem::exists(path, ignored)) continue;
    lib.tried.push_back(fmt::format("{} is empty: told the loader of {}", lists.string(), path));
    setenv(vendors_variable, path, 0);
    return;
  }
  lib.tried.push_back(fmt::format("{} is empty, and there is no libnvidia-opencl.so.1", lists.string()));
}

Library find() {
  Library lib;
  name_vendor(lib);
  for (const char* name : loaders) {
    void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (!handle) {
      lib.tried.push_back(fmt::format("{}: not there", name));
      continue;
    }
    if (!take_functions(handle, lib)) {
      lib.tried.push_back(fmt::format("{}: older than OpenCL 1.2", name));
      continue;
    }
    lib.found = knows_platforms(lib);
    lib.tried.push_back(fmt::format("{}: {}", name, lib.found ? "loaded" : "knows no platform"));
    if (lib.found) break;
  }
  return lib;
}

}  // namespace

const Library& library() {
  static const Library found = find();
  return found;
}

}  // namespace scree::opencl
