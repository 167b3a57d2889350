#include "scree/app/insertion_progress.h"

#include <utility>

namespace scree {
namespace {

constexpr double patience = 3, terminal_interval = 0.5, plain_interval = 10;  // [s]

}  // namespace

InsertionProgress::InsertionProgress(ProgressOptions options)
    : options_(std::move(options)), due_(options_.now() + patience) {}

void InsertionProgress::operator()(const std::string& group, std::size_t placed, std::size_t wanted) {
  const double now = options_.now();
  const bool ends = placed == wanted;
  if (ends ? !begun_ : now < due_) return;
  due_ = now + (options_.terminal ? terminal_interval : plain_interval);
  std::fprintf(options_.stream, "%sinserting '%s': %zu of %zu placed%s", options_.terminal ? "\r" : "", group.c_str(),
               placed, wanted, options_.terminal && !ends ? "" : "\n");
  std::fflush(options_.stream);
  begun_ = options_.terminal && !ends;
}

}  // namespace scree
