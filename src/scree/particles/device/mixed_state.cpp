#include "scree/particles/device/mixed_state.h"

#include <algorithm>
#include <cmath>

#include "scree/particles/reach.h"

namespace scree {
namespace {

constexpr std::size_t group = 128, word = sizeof(float);

/// Of nothing, 1.
double power_of_two_near(double x) { return x > 0 ? std::exp2(std::round(std::log2(x))) : 1; }

/// Of those that move; 0 if nobody does.
double mean_mass(const Particles& particles) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (const double inverse = particles.motion.row(i)[lane::inverse_mass]; inverse > 0) {
      sum += 1 / inverse;
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

/// The stiffest of the laws [N/m].
double stiffness_of(const Materials& materials, double length) {
  double most = 0;
  for (const sc_pair_law& law : materials.law) most = std::max({most, law.stiffness, law.young * length});
  return most;
}

void set_units(const ParticleSystem& s, sc_fixed_space& out) {
  out.length = power_of_two_near(sizes_of(s.particles).mean_radius);
  out.mass = power_of_two_near(mean_mass(s.particles));
  const double stiffness = stiffness_of(s.materials, out.length);
  out.time = power_of_two_near(stiffness > 0 ? std::sqrt(out.mass / stiffness) : 0);
}

}  // namespace

sc_fixed_space fixed_space_of(const ParticleSystem& s, double reach) {
  sc_fixed_space units{};
  set_units(s, units);
  return fixed_space_of(s.domain, reach, units);
}

sc_fixed_space fixed_space_of(const Domain& domain, double reach, const sc_fixed_space& units) {
  sc_fixed_space out = units;
  double widest = 2 * reach;  // what ticks have to measure with 32 bits
  double step[3];
  out.open = 0;
  for (int k = 0; k < 3; ++k) {
    out.open |= (domain.open[k][0] ? 1 << k : 0) | (domain.open[k][1] ? 8 << k : 0);
    const double length = domain.length(k);
    out.periodic[k] = domain.periodic[k];
    out.span[k] = out.periodic[k] ? length : 2 * length;
    out.low[k] = out.periodic[k] ? domain.min[k] : domain.min[k] - 0.5 * length;
    out.turn[k] = 0;
    // A little more than twice the reach: the sign of a difference must be certain.
    while (out.turn[k] < 31 && out.span[k] > 2 * 2.2 * reach * std::exp2(out.turn[k])) ++out.turn[k];
    const double window = out.span[k] * std::exp2(-out.turn[k]);
    step[k] = window * 0x1p-32;
    widest = std::max(widest, window);
  }
  out.tick = std::exp2(std::ceil(std::log2(widest * 0x1p-32)));
  for (int k = 0; k < 3; ++k) out.scale[k] = static_cast<unsigned>(std::lround(step[k] / out.tick * 0x1p31));
  return out;
}

void write_memory(opencl::DeviceBuffer& to, const std::vector<double>& rows, const std::optional<MemoryUnits>& units) {
  if (!units) return to.write(rows.data(), rows.size() * sizeof rows[0]);
  std::vector<float> narrow(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    narrow[k] = static_cast<float>(rows[k] / (k % 4 < 3 ? units->stretch : units->last));
  to.write(narrow.data(), narrow.size() * sizeof narrow[0]);
}

std::vector<double> read_memory(const opencl::DeviceBuffer& from, std::size_t first, std::size_t count,
                                const std::optional<MemoryUnits>& units) {
  std::vector<double> rows(4 * count);
  if (!units) {
    from.read(rows.data(), rows.size() * sizeof rows[0], 4 * first * sizeof rows[0]);
    return rows;
  }
  std::vector<float> narrow(rows.size());
  from.read(narrow.data(), narrow.size() * sizeof narrow[0], 4 * first * sizeof narrow[0]);
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k] = (k % 4 < 3 ? units->stretch : units->last) * static_cast<double>(narrow[k]);
  return rows;
}

void MixedState::for_each_row(int now, const std::function<void(opencl::DeviceBuffer&, std::size_t)>& visit) {
  for (opencl::DeviceBuffer* rows : {&near[now], &speed[now], &spin[now]}) visit(*rows, 4 * word);
  for (opencl::DeviceBuffer* rows : {&rest_places, &rest_speeds, &rest_spins}) visit(*rows, 3 * word);
  visit(excess_of, word);
}

void MixedState::for_each_buffer(const std::function<void(opencl::DeviceBuffer&, std::size_t)>& visit) {
  for_each_row(0, visit);
  for (opencl::DeviceBuffer* rows : {&near[1], &speed[1], &spin[1], &listed}) visit(*rows, 4 * word);
}

void MixedState::send_laws(const opencl::Device& device, const Materials& materials, const sc_fixed_space& units) {
  std::vector<float> numbers;
  for (const sc_pair_law& law : materials.law) {
    const std::vector<float> own = narrowed(sc_law_in_units(law, units));
    numbers.insert(numbers.end(), own.begin(), own.end());
  }
  laws = opencl::sent(device, numbers);
}

void MixedState::take(opencl::Program& program, int now, std::size_t first, std::size_t count,
                      const opencl::DeviceBuffer& motion, const opencl::DeviceBuffer& spins,
                      const opencl::DeviceBuffer& excess) {
  program.run("sc_narrow_state", count, group, static_cast<int>(first), static_cast<int>(count), space, motion, spins,
              excess, near[now], speed[now], spin[now], rest_places, rest_speeds, rest_spins, excess_of);
}

void MixedState::take_speeds(opencl::Program& program, int now, int step, const opencl::DeviceBuffer& stale,
                             std::size_t count, const opencl::DeviceBuffer& motion, const opencl::DeviceBuffer& spins) {
  program.run("sc_narrow_speeds", count, group, step, stale, static_cast<int>(count), space, motion, spins, speed[now],
              spin[now], rest_places, rest_speeds, rest_spins);
}

void MixedState::move_to(const sc_fixed_space& other, opencl::Program& program, int now, std::size_t count,
                         const opencl::DeviceBuffer& motion) {
  program.run("sc_change_windows", count, group, static_cast<int>(count), space, other, motion, near[now], rest_places);
  space = other;
}

void MixedState::give(opencl::Program& program, int now, std::size_t count, const opencl::DeviceBuffer& motion,
                      const opencl::DeviceBuffer& spins) const {
  program.run("sc_widen_state", count, group, static_cast<int>(count), space, near[now], speed[now], spin[now],
              rest_places, rest_speeds, rest_spins, motion, spins);
}

std::size_t MixedState::bytes() const {
  std::size_t sum = laws.bytes();
  const_cast<MixedState*>(this)->for_each_buffer(
      [&](const opencl::DeviceBuffer& rows, std::size_t) { sum += rows.bytes(); });
  return sum;
}

}  // namespace scree
