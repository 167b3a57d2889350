#include "scree/data/particles.h"

#include <algorithm>

namespace scree {

void Particles::resize(std::size_t n) {
  for_each_field([&](auto, auto& column, auto...) { column.values.resize(n * column.components); });
  size_ = n;
}

void Particles::permute(const std::vector<std::uint32_t>& order) {
  for_each_field([&](auto, auto& column, auto...) {
    using C = std::remove_reference_t<decltype(column)>;
    Buffer<typename C::value_type> moved(column.values.size());
    const auto* from = column.values.data();
    auto* to = moved.data();
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < order.size(); ++i)
      std::copy_n(from + std::size_t{order[i]} * C::components, C::components, to + i * C::components);
    column.values = std::move(moved);
  });
}

std::size_t Particles::bytes_per_particle() {
  std::size_t bytes = 0;
#define FIELD(name, type, components, travels, saved, doc) bytes += sizeof(type) * components;
  SCREE_PARTICLE_FIELDS(FIELD)
#undef FIELD
  return bytes;
}

}  // namespace scree
