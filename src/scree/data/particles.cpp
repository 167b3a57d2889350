#include "scree/data/particles.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>

namespace scree {

void Particles::resize(std::size_t n) {
  // First what goes, so that what is added is zero.
  for_each_field([&](auto, auto& column, auto...) {
    column.values.resize(std::min(n, size_) * column.components);
    column.values.resize(n * column.components);
  });
  size_ = n;
  ghosts_ = 0;
}

void Particles::resize_ghosts(std::size_t n) {
  resize(size_);
  for_each_field([&](auto, auto& column, auto...) { column.values.resize((size_ + n) * column.components); });
  ghosts_ = n;
}

void Particles::permute(const std::vector<std::uint32_t>& order) {
  std::size_t widest = 0;
  for_each_field([&](auto, auto& column, auto...) {
    widest = std::max(widest, column.values.size() * sizeof(*column.values.data()));
  });
  // By way of memory that nobody clears and back: new columns would be cleared by one thread, page by page.
  const auto scratch = std::make_unique_for_overwrite<std::byte[]>(widest);
  for_each_field([&](auto, auto& column, auto...) {
    using C = std::remove_reference_t<decltype(column)>;
    auto* rows = column.values.data();
    auto* moved = reinterpret_cast<typename C::value_type*>(scratch.get());
#pragma omp parallel
    {
#pragma omp for schedule(static)
      for (std::size_t i = 0; i < order.size(); ++i)
        std::copy_n(rows + std::size_t{order[i]} * C::components, C::components, moved + i * C::components);
#pragma omp for schedule(static)
      for (std::size_t i = 0; i < order.size(); ++i)
        std::copy_n(moved + i * C::components, C::components, rows + i * C::components);
    }
    column.values.resize(order.size() * C::components);
  });
  size_ = order.size();
  ghosts_ = 0;
}

void Particles::couple(bool with_turning) {
  coupled_ = true;
  turned_ = with_turning;
  resize(size_);
}

void Particles::give_heat() {
  warm_ = true;
  resize(size_);
}

Particles Particles::none_alike() const {
  Particles none(shaped_);
  none.coupled_ = coupled_;
  none.turned_ = turned_;
  none.warm_ = warm_;
  return none;
}

void Particles::append(const Particles& others) {
  const std::size_t old = size_;
  resize(old + others.size());
#define FIELD(name, type, components, travels, saved, doc) \
  std::copy_n(others.name.values.data(), others.size() * components, name.row(old));
  SCREE_PARTICLE_FIELDS(FIELD)
  if (shaped_) {
    SCREE_SHAPE_FIELDS(FIELD)
  }
  if (coupled_ && others.coupled_) {
    SCREE_COUPLED_FIELDS(FIELD)
  }
  if (turned_ && others.turned_) {
    SCREE_TURNED_FIELDS(FIELD)
  }
  if (warm_ && others.warm_) {
    SCREE_HEAT_FIELDS(FIELD)
  }
#undef FIELD
}

std::size_t Particles::bytes_per_particle() const {
  std::size_t bytes = 0;
  for_each_field([&](auto, const auto& column, auto...) {
    using C = std::remove_cvref_t<decltype(column)>;
    bytes += sizeof(typename C::value_type) * C::components;
  });
  return bytes;
}

std::vector<std::uint32_t> order_by_id(const Particles& particles) {
  std::vector<std::uint32_t> order(particles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return particles.id[a] < particles.id[b]; });
  return order;
}

}  // namespace scree
