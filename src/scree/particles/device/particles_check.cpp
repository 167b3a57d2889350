// What a run on a device begins with: it must give the host's numbers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "scree/base/error.h"
#include "scree/base/random.h"
#include "scree/particles/device/particles.h"
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

std::array<double, 16> numbers_of(const sc_contact_result& r) {
  const sc_contact_action& a = r.action;
  return {a.normal_force.x, a.tangential_force.x, a.tangential_force.y, a.tangential_force.z,
          a.couple.x,       a.couple.y,           a.couple.z,           a.loss_normal,
          a.loss_sliding,   a.loss_rolling,       r.state.slide.x,      r.state.slide.y,
          r.state.roll.x,   r.state.twist,        r.state.approach,     r.state.slid};
}

/// sc_contact_result as it is in single precision.
struct SingleResult {
  float normal_force[3], tangential_force[3], couple[3], loss_normal, loss_sliding, loss_rolling;
  std::int32_t touching;
  float slide[3], roll[3], twist, approach, acted, slid;
};

std::array<double, 16> numbers_of(const SingleResult& r) {
  return {r.normal_force[0],
          r.tangential_force[0],
          r.tangential_force[1],
          r.tangential_force[2],
          r.couple[0],
          r.couple[1],
          r.couple[2],
          r.loss_normal,
          r.loss_sliding,
          r.loss_rolling,
          r.slide[0],
          r.slide[1],
          r.roll[0],
          r.twist,
          r.approach,
          r.slid};
}

}  // namespace

void DeviceParticles::refuse(const std::string& what) const {
  throw ResourceError(fmt::format("{} ({}, driver {}) does not compute as this program does: {}", device_.info().name,
                                  device_.info().platform, device_.info().driver, what));
}

void DeviceParticles::check_kernels() {
  check_sizes("sc_sizes", {sizeof(sc_device_step), sizeof(sc_findings), sizeof(sc_wall), sizeof(sc_wall_pose),
                           sizeof(sc_field), sizeof(sc_flow_shape)});
  check_sizes("sc_law_sizes", {sizeof(sc_pair_law), sizeof(sc_contact_time), sizeof(sc_touch), sizeof(sc_contact_state),
                               sizeof(sc_contact_result)});
  check_sums();
  check_law();
  if (!mixed_) return;
  check_sizes("sc_mixed_sizes", {sizeof(sc_fixed_space)});
  // Numbers alone, of half the size; the result has one integer, after which nothing need be aligned.
  check_sizes("sf_law_sizes", {sizeof(sc_pair_law) / 2, sizeof(sc_contact_time) / 2, sizeof(sc_touch) / 2,
                               sizeof(sc_contact_state) / 2, sizeof(SingleResult)});
  check_single_law();
}

void DeviceParticles::check_sizes(const char* kernel, const std::vector<int>& expected) {
  opencl::DeviceBuffer found(device_, expected.size() * sizeof(int));
  program_.run(kernel, 1, 1, found);
  if (const auto sizes = found.values<int>(expected.size()); sizes != expected)
    refuse(fmt::format("structs have the sizes {}, not {}", fmt::join(sizes, " "), fmt::join(expected, " ")));
}

/// A scan over several blocks.
void DeviceParticles::check_sums() {
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
void DeviceParticles::check_law() {
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
    const auto mine = numbers_of(own), its = numbers_of(theirs[k]);
    for (std::size_t l = 0; l < mine.size(); ++l)
      if (!(mine[l] == its[l]) && !(std::isnan(mine[l]) && std::isnan(its[l])))
        refuse(fmt::format("number {} of a contact's law is {:.17g}, not {:.17g}", l, its[l], mine[l]));
    if (own.action.touching != theirs[k].action.touching) refuse("it takes a contact for none");
  }
}

/// The chosen law in single precision, to what rounding may do. Each number is compared with the largest of its kind.
/// Where a contact is about to begin or to slide, rounding may decide: that happens once in a thousand runs.
void DeviceParticles::check_single_law() {
  constexpr double most_wrong = 1e-4;
  constexpr int most_decided = 2;
  const sc_fixed_space& u = mixed_->space;
  const double r = range_ > 0 ? 0.5 * range_ / u.length : 1;
  const sc_contact_time time{0.1, 0.05, 0.1};
  std::vector<float> touches, states;
  std::vector<std::array<double, 16>> mine;
  std::array<double, 16> largest{};
  for (int k = 0; k < tries; ++k) {
    const sc_touch touch = touch_of(k, r);
    const sc_contact_state state = state_of(k, r);
    for (const auto& [to, numbers] : {std::pair{&touches, narrowed(touch)}, {&states, narrowed(state)}})
      to->insert(to->end(), numbers.begin(), numbers.end());
    mine.push_back(numbers_of(sc_contact_act(laws_of_run_, sc_law_in_units(first_law_, u), touch, time, state)));
    for (std::size_t l = 0; l < largest.size(); ++l) largest[l] = std::max(largest[l], std::abs(mine.back()[l]));
  }
  const auto theirs = single_results(time, touches, states);
  int decided = 0;
  for (int k = 0; k < tries; ++k)
    for (std::size_t l = 0; l < largest.size(); ++l) {
      const double own = mine[k][l], its = theirs[k][l];
      if (std::abs(its - own) <= most_wrong * largest[l] || (std::isnan(its) && std::isnan(own))) continue;
      if (++decided > most_decided)
        refuse(fmt::format("number {} of a contact's law in single precision is {:.9g}, not {:.9g}", l, its, own));
      break;
    }
}

/// What the law in single precision makes of contacts.
std::vector<std::array<double, 16>> DeviceParticles::single_results(const sc_contact_time& time,
                                                                    const std::vector<float>& touches,
                                                                    const std::vector<float>& states) {
  opencl::DeviceBuffer touch_rows(device_, touches.size() * sizeof(float));
  opencl::DeviceBuffer state_rows(device_, states.size() * sizeof(float));
  opencl::DeviceBuffer results(device_, tries * sizeof(SingleResult));
  touch_rows.write(touches.data(), touch_rows.bytes());
  state_rows.write(states.data(), state_rows.bytes());
  std::array<float, 3> single_time{};
  std::ranges::copy(narrowed(time), single_time.begin());
  program_.run("sf_try_law", tries, tries, tries, single_time, mixed_->laws, touch_rows, state_rows, results);
  std::vector<std::array<double, 16>> out;
  for (const SingleResult& result : results.values<SingleResult>(tries)) out.push_back(numbers_of(result));
  return out;
}

}  // namespace scree
