// Who comes and who goes while particles stay on a device.
#include <algorithm>
#include <unordered_map>

#include "scree/particles/device/particles.h"

namespace scree {

/// Memory for so many rows; those that are there stay.
void DeviceParticles::reserve(std::size_t rows) {
  if (rows <= rows_) return;
  const std::size_t before = rows_;
  rows_ = before == 0 ? rows : rows + rows / 8;
  std::size_t widest = 4 * sizeof(double);
  const auto grow = [&](opencl::DeviceBuffer& buffer, std::size_t row_bytes) {
    opencl::DeviceBuffer larger(device_, rows_ * row_bytes);
    larger.copy_from(buffer, before * row_bytes);
    buffer = std::move(larger);
    widest = std::max(widest, row_bytes);
  };
  for (auto& [name, values] : columns_) grow(values, row_bytes_.at(name));
  for (int k = 0; k < (mixed_ ? 1 : 2); ++k) {
    grow(motion_[k], row_bytes_.at("motion"));
    grow(spin_[k], row_bytes_.at("spin"));
  }
  for (opencl::DeviceBuffer* places : {&cell_of_, &order_, &place_, &gone_}) grow(*places, sizeof(std::int32_t));
  if (mixed_)
    mixed_->for_each_buffer(grow);
  else
    grow(listed_, 4 * sizeof(double));
  if (planes_) grow(planes_->passed, planes_->row_bytes());
  make_scratch(widest);
  found_ = opencl::DeviceBuffer(device_, finding_groups() * sizeof(sc_findings));
}

/// Room for so wide rows of all particles on their way.
void DeviceParticles::make_scratch(std::size_t row_bytes) {
  if (scratch_.bytes() < rows_ * row_bytes) scratch_ = opencl::DeviceBuffer(device_, rows_ * row_bytes);
}

void DeviceParticles::put_rows(const std::vector<std::int32_t>& rows, const Particles& values) {
  if (rows.empty()) return;
  const opencl::DeviceBuffer to = opencl::sent(device_, rows);
  values.for_each_field([&](std::string_view name, const auto& from, auto...) {
    const std::size_t row_bytes = row_bytes_.at(name);
    scratch_.write(from.values.data(), rows.size() * row_bytes);
    put(to, rows.size(), row_bytes, scratch_, column(name));
  });
}

/// Those who come stand after the others until lists are made.
void DeviceParticles::append(const Particles& fresh) {
  reserve(n_ + come_ + fresh.size());
  fresh.for_each_field([&](std::string_view name, const auto& values, auto...) {
    const std::size_t row_bytes = row_bytes_.at(name);
    column(name).write(values.values.data(), fresh.size() * row_bytes, (n_ + come_) * row_bytes);
  });
  if (mixed_)
    mixed_->take(program_, now_, n_ + come_, fresh.size(), column("motion"), column("spin"), column("effect_excess"));
  come_ += fresh.size();
}

/// Those who go are marked until lists are made.
void DeviceParticles::dismiss(const std::vector<std::int32_t>& rows) {
  put_words(rows, 1, gone_);
  gone_count_ += rows.size();
}

/// Lists have to hold who is as large as any that have been there.
void DeviceParticles::reach_as_far_as(const ParticleSystem& system, const Sizes& sizes) {
  // The mean decides about speed alone; that of nobody is zero.
  if (sizes_.mean_radius == 0) sizes_.mean_radius = sizes.mean_radius;
  sizes_.radius = std::max(sizes_.radius, sizes.radius);
  sizes_.excess = std::max(sizes_.excess, sizes.excess);
  sizes_.effect_radius = std::max(sizes_.effect_radius, sizes.effect_radius);
  sizes_.contact_radius = std::max(sizes_.contact_radius, sizes.contact_radius);
  constants_.margin = margin_of(system, sizes_);
  beyond_ = reach_beyond_effects(system, sizes_);
  range_ = 2 * sizes_.effect_radius + beyond_;
  shortest_skin_ = 0.08 * sizes_.mean_radius;
  longest_skin_ = sizes_.mean_radius;
  if (adapts_) skin_ = std::clamp(skin_, shortest_skin_, longest_skin_);
}

/// Two bodies that are on a list are no further apart [m].
double DeviceParticles::farthest() const { return range_ + 2 * std::max(skin_, longest_skin_); }

/// Windows of places have to be wide enough for those who have come; units for the first of all.
void DeviceParticles::fit_space(const ParticleSystem& system) {
  const sc_fixed_space fitting =
      n_ == 0 ? fixed_space_of(system, farthest()) : fixed_space_of(system.domain, farthest(), mixed_->space);
  if (n_ == 0) mixed_->send_laws(device_, system.materials, fitting);
  mixed_->move_to(fitting, program_, now_, n_, column("motion"));
}

void DeviceParticles::put_back(const PartOfDevice& before, const ParticleSystem& system) {
  take_passings();
  const Particles& after = system.particles;
  std::unordered_map<std::int64_t, std::int32_t> row_of;
  for (std::size_t i = 0; i < before.id.size(); ++i) row_of[before.id[i]] = before.rows[i];
  std::vector<std::uint32_t> staying, coming;
  std::vector<std::int32_t> rows, gone;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto found = row_of.find(after.id[i]);
    if (found == row_of.end()) {
      coming.push_back(static_cast<std::uint32_t>(i));
      continue;
    }
    staying.push_back(static_cast<std::uint32_t>(i));
    rows.push_back(found->second);
    row_of.erase(found);
  }
  for (const auto& [id, row] : row_of) gone.push_back(row);
  Particles stay = after, come = after;
  stay.permute(staying);
  come.permute(coming);
  if (come.size() > 0) {
    reach_as_far_as(system, sizes_of(come));
    if (mixed_) fit_space(system);
  }
  put_rows(rows, stay);
  // Places keep their last bits, since nobody is moved; those who stay may have been pushed.
  if (mixed_) mixed_->take_speeds(program_, now_, 0, stale_, n_, column("motion"), column("spin"));
  dismiss(gone);
  append(come);
  wall_poses_.write(system.walls.poses.data(), system.walls.poses.size() * sizeof(sc_wall_pose));
  make_lists();
}

}  // namespace scree
