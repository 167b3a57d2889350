// What a run on a device begins with: it must give the host's numbers.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "scree/base/error.h"
#include "scree/base/random.h"
#include "scree/particles/device/spheres.h"
#include "scree/physics/contact/law.h"

namespace scree {
namespace {

constexpr int tries = 64;

/// Numbers between -1 and 1 that depend on their place alone.
double draw(int contact, int place) {
  return 2 * uniform_pair(
                 {.count = static_cast<std::uint64_t>(contact), .draw = static_cast<std::uint32_t>(place)})[0] -
         1;
}

/// Contacts of a body of radius r, some apart, some with a memory.
sc_touch touch_of(int k, double r) {
  sc_touch t{};
  const sc_vec n = sc_make_vec(draw(k, 0), draw(k, 1), draw(k, 2));
  t.normal = sc_scale(1 / sc_norm(n), n);
  t.overlap = 0.05 * r * draw(k, 3);
  t.reach = t.overlap + 0.02 * r;
  t.velocity = sc_make_vec(draw(k, 4), draw(k, 5), draw(k, 6));
  t.spin = sc_scale(1 / r, sc_make_vec(draw(k, 7), draw(k, 8), draw(k, 9)));
  t.mass = t.reduced = 1000 * r * r * r * (1.5 + draw(k, 10));
  t.radius = r;
  return t;
}

sc_contact_state state_of(int k, double r) {
  sc_contact_state s{};
  if (k % 3 == 0) return s;
  s.slide = sc_scale(0.01 * r, sc_make_vec(draw(k, 11), draw(k, 12), draw(k, 13)));
  s.roll = sc_scale(0.01, sc_make_vec(draw(k, 14), draw(k, 15), draw(k, 16)));
  s.twist = 0.01 * draw(k, 17);
  s.approach = draw(k, 18);
  s.acted = 1;
  s.slid = k % 3 == 1;
  return s;
}

}  // namespace

void DeviceSpheres::refuse(const std::string& what) const {
  throw ResourceError(fmt::format("{} ({}, driver {}) does not compute as this program does: {}", device_.info().name,
                                  device_.info().platform, device_.info().driver, what));
}

void DeviceSpheres::check_kernels() {
  const std::array<int, 8> expected{sizeof(sc_device_step),   sizeof(sc_findings),      sizeof(sc_pair_law),
                                    sizeof(sc_wall),          sizeof(sc_wall_pose),     sizeof(sc_touch),
                                    sizeof(sc_contact_state), sizeof(sc_contact_result)};
  opencl::DeviceBuffer found(device_, sizeof expected);
  program_.run("sc_sizes", 1, 1, found);
  if (const auto sizes = found.values<int>(expected.size()); !std::equal(sizes.begin(), sizes.end(), expected.begin()))
    refuse(fmt::format("structs have the sizes {}, not {}", fmt::join(sizes, " "), fmt::join(expected, " ")));
  check_sums();
  check_law();
}

/// A scan over several blocks.
void DeviceSpheres::check_sums() {
  std::vector<std::int32_t> numbers(5000);
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<std::int32_t>(k * k % 7);
  opencl::DeviceBuffer values(device_, numbers.size() * sizeof numbers[0]);
  values.write(numbers.data(), values.bytes());
  scan(values, static_cast<int>(numbers.size()));
  const auto sums = values.values<std::int32_t>(numbers.size());
  std::exclusive_scan(numbers.begin(), numbers.end(), numbers.begin(), 0);
  if (sums != numbers) refuse("sums of integers differ");
}

/// The chosen law, to the last bit.
void DeviceSpheres::check_law() {
  const double r = 0.5 * range_;
  const sc_contact_time time{1e-4, 0.5e-4, 1e-4};
  std::vector<sc_touch> touch;
  std::vector<sc_contact_state> state;
  for (int k = 0; k < tries; ++k) {
    touch.push_back(touch_of(k, r));
    state.push_back(state_of(k, r));
  }
  opencl::DeviceBuffer touches(device_, tries * sizeof touch[0]), states(device_, tries * sizeof state[0]);
  opencl::DeviceBuffer results(device_, tries * sizeof(sc_contact_result));
  touches.write(touch.data(), touches.bytes());
  states.write(state.data(), states.bytes());
  program_.run("sc_try_law", tries, tries, tries, time, laws_, touches, states, results);
  const auto theirs = results.values<sc_contact_result>(tries);
  for (int k = 0; k < tries; ++k) {
    const sc_contact_result own = sc_contact_act(laws_of_run_, first_law_, touch[k], time, state[k]);
    const auto numbers = [](const sc_contact_result& r0) {
      const sc_contact_action& a = r0.action;
      return std::array{a.normal_force.x, a.tangential_force.x, a.tangential_force.y, a.tangential_force.z,
                        a.couple.x,       a.couple.y,           a.couple.z,           a.loss_normal,
                        a.loss_sliding,   a.loss_rolling,       r0.state.slide.x,     r0.state.slide.y,
                        r0.state.roll.x,  r0.state.twist,       r0.state.approach,    r0.state.slid};
    };
    const auto mine = numbers(own), its = numbers(theirs[k]);
    for (std::size_t l = 0; l < mine.size(); ++l)
      if (!(mine[l] == its[l]) && !(std::isnan(mine[l]) && std::isnan(its[l])))
        refuse(fmt::format("number {} of a contact's law is {:.17g}, not {:.17g}", l, its[l], mine[l]));
    if (own.action.touching != theirs[k].action.touching) refuse("it takes a contact for none");
  }
}

}  // namespace scree
