#include "scree/base/memory.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace scree {
namespace {

std::optional<double> first_number(const char* path) {
  std::ifstream file(path);
  double value = 0;
  if (file >> value) return value;
  return {};
}

}  // namespace

std::optional<double> available_memory() {
  std::optional<double> available;
  std::ifstream table("/proc/meminfo");
  for (std::string word; table >> word;)
    if (double kibibytes = 0; word == "MemAvailable:" && table >> kibibytes) available = 1024 * kibibytes;
  const auto limit = first_number("/sys/fs/cgroup/memory.max"), used = first_number("/sys/fs/cgroup/memory.current");
  if (available && limit && used) available = std::min(*available, std::max(0.0, *limit - *used));
  return available;
}

}  // namespace scree
