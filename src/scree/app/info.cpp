#include "scree/app/info.h"

#include <fmt/format.h>
#include <H5public.h>
#include <openssl/crypto.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <functional>

#include "scree/app/data_files.h"
#include "scree/app/run.h"
#include "scree/base/version.h"
#include "scree/compute/opencl/device.h"
#include "scree/mpi/ranks.h"
#include "scree/particles/sweep.h"

namespace scree {

namespace {

constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;

/// The devices by the names that `scree run --device` takes; where there is none, what was tried.
void list_devices(const std::function<void(const std::string&, const std::string&)>& line) {
  line("device cpu", "this machine's processors");
  const auto all = opencl::devices();
  for (std::size_t k = 0; k < all.size(); ++k)
    line(fmt::format("device opencl:{}", k),
         fmt::format("{}, {:.1f} GiB{}; {}, driver {}", all[k].name, all[k].memory / gibibyte,
                     all[k].fp64 ? ", double or mixed precision" : ", no double precision", all[k].platform,
                     all[k].driver));
  if (!all.empty()) return;
  for (const std::string& tried : opencl::library().tried) line("no OpenCL", tried);
}

}  // namespace

std::string info_text() {
  utsname system{};
  uname(&system);
  const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  std::string text;
  const auto line = [&text](const std::string& what, const std::string& value) {
    text += fmt::format("{:<18} {}\n", what, value);
  };
  line("scree", fmt::format("{} ({})", version, commit));
  line("build", fmt::format("{}, {}", build_type, compiler));
  line("HDF5", fmt::format("{}.{}.{}", major, minor, release));
  line("OpenSSL", OpenSSL_version(OPENSSL_VERSION_STRING));
  line("instruction set", sweep_kernels({}, 1).name);
  line("processors",
       fmt::format("{} (this process may use {})", sysconf(_SC_NPROCESSORS_ONLN), processors_alone().mine));
  line("memory", fmt::format("{:.1f} GiB", memory / gibibyte));
  line("system", fmt::format("{} {} {}", system.sysname, system.release, system.machine));
  line("examples", data_directory("examples").string());
  list_devices(line);
  return text;
}

}  // namespace scree
