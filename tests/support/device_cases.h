// Cases for the tests of devices, and the comparison of a run on a device with one on the CPU.
#pragma once

#include <gtest/gtest.h>

#include "scree/app/device_run.h"
#include "scree/base/error.h"
#include "support/foreign_leaks.h"
#include "unit/engine_cases.h"

namespace scree::test {

/// Particles of two materials and of many sizes between two planes, periodic sideways, one of them fixed.
inline std::string slab(const LawChoice& laws, const std::string& more = "") {
  return "[simulation]\nend = 10\ntime_step = 2e-5\nmax_overlap = 0.9\n"
         "[domain]\nmin = [0, 0, -0.001]\nmax = [0.024, 0.024, 0.031]\nperiodic = [true, true, false]\n"
         "[contact]\n" +
         laws.contact + material_text(laws, "glass", 2000, 0.8) + material_text(laws, "rubber", 1000, 0.5) +
         "[[particles]]\nname = \"anchor\"\nmaterial = \"rubber\"\ninsert = \"positions\"\ndiameter = 3.5e-3\n"
         "positions = [[0.012, 0.012, 0.0295]]\nmotion = \"fixed\"\n"
         "[[particles]]\nname = \"grains\"\nmaterial = \"glass\"\ninsert = \"random\"\ncount = 90\n"
         "region_min = [0, 0, 0]\nregion_max = [0.024, 0.024, 0.03]\n"
         "diameter = { distribution = \"uniform\", min = 3e-3, max = 6e-3 }\n"
         "effect_gap = 2e-4\nangular_velocity = [10, -20, 5]\nvelocity = { type = \"random\", deviation = 0.5 }\n"
         "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"rubber\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
         "[[walls]]\nname = \"lid\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 0.03]\nnormal = [0, 0, "
         "-1]\n" +
         more;
}

inline const char* const gravity = "[gravity]\ntype = \"uniform\"\nacceleration = [0.3, 0, -9.81]\n";

inline const char* const rough_laws =
    "normal = \"linear\"\ntangential = \"history\"\nrolling = \"spring\"\ntwisting = \"spring\"\n";
inline const char* const rough_material =
    "friction = 0.5\nfriction_sliding = 0.3\nrolling_friction = 0.1\ntwisting_friction = 0.1\n";

/// Grains thrown about between the walls of `walls`, which must close the region; some bounce, all rub.
inline std::string vessel(const std::string& walls,
                          const std::string& region =
                              "region_min = [0.002, 0.002, 0.006]\n"
                              "region_max = [0.028, 0.028, 0.028]\n",
                          int count = 60) {
  const LawChoice laws{"rough", rough_laws, rough_material};
  return "[simulation]\nend = 10\ntime_step = 2e-5\nmax_overlap = 0.9\n"
         "[domain]\nmin = [-0.02, -0.02, -0.02]\nmax = [0.05, 0.05, 0.05]\n[contact]\n" +
         laws.contact + material_text(laws, "glass", 2000, 0.8) + material_text(laws, "rubber", 1000, 0.5) +
         "[[particles]]\nname = \"grains\"\nmaterial = \"glass\"\ninsert = \"random\"\ncount = " +
         std::to_string(count) + "\n" + region +
         "diameter = { distribution = \"uniform\", min = 3e-3, max = 5e-3 }\n"
         "effect_gap = 2e-4\nangular_velocity = [10, -20, 5]\nvelocity = { type = \"random\", deviation = 0.5 }\n" +
         gravity + walls;
}

inline std::string wall(const std::string& type, const std::string& keys, const std::string& material = "rubber") {
  return "[[walls]]\nmaterial = \"" + material + "\"\ntype = \"" + type + "\"\n" + keys + "\n";
}

inline const std::string closed_box = wall("box", "min = [0, 0, 0]\nmax = [0.03, 0.03, 0.03]");

/// A floor of 2 x `cells` x `cells` triangles in the box, up and down like a tray for eggs: every sphere on it meets
/// edges and corners.
inline std::string egg_tray(int cells, const std::string& more = "") {
  std::string text = "vertices = [\n";
  const auto vertex = [&](int x, int y) {
    const double side = 0.03 / cells;
    text += "[" + std::to_string(x * side) + ", " + std::to_string(y * side) + ", " +
            std::to_string((x + y) % 2 ? 0.0035 : 0.0015) + "], ";
  };
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y) {
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) vertex(x + dx, y + dy);
      text += "\n";
    }
  return wall("triangles", text + "]\n" + more);
}

inline opencl::DeviceInfo first_device() {
  const auto all = opencl::devices();
  if (all.empty()) throw std::runtime_error("these tests need an OpenCL device: install pocl-opencl-icd");
  return all.front();
}

/// All that a run tells, books included.
struct Told {
  Outcome outcome;
  std::int64_t wall_contacts;
  std::vector<double> books;
  bool operator==(const Told&) const = default;
};

inline Told told_by(Simulation& s) {
  Told out{
      {s.state_hash(), s.tally().contacts, s.tally().impacts, s.tally().impact_speed}, s.tally().wall_contacts, {}};
  const Particles& p = s.whole().particles;
  for (const std::uint32_t i : order_by_id(p)) {
    for (const auto* column : {&p.loss, &p.work, &p.impulse, &p.angular_impulse})
      for (int k = 0; k < 4; ++k) out.books.push_back(column->row(i)[k] + 0.0);  // -0 is 0
    for (int k = 0; k < 3; ++k) out.books.push_back(p.image.row(i)[k]);
  }
  return out;
}

inline Told told_on_cpu(const Case& c, int steps) {
  Simulation s(c, 1);
  advance(s, steps);
  return told_by(s);
}

inline Told told_on_device(const Case& c, int steps) {
  Simulation s(c, 1);
  s.use_device(first_device());
  advance(s, steps);
  return told_by(s);
}

inline void expect_the_same(const std::string& text, int steps, const Overrides& overrides = {}) {
  const Case c = case_of(text, overrides);
  const Told truth = told_on_cpu(c, steps);
  EXPECT_GT(truth.outcome.contacts, steps) << "the test tests little";
  const Told device = told_on_device(c, steps);
  EXPECT_EQ(device.outcome, truth.outcome);
  EXPECT_EQ(device.wall_contacts, truth.wall_contacts);
  EXPECT_EQ(device.books, truth.books);
}

/// Steps on the CPU, then on the device, then on the CPU again, by way of checkpoints.
inline void expect_the_same_in_turns(const Case& c, const std::array<int, 3>& steps) {
  const Told truth = told_on_cpu(c, steps[0] + steps[1] + steps[2]);
  Simulation first(c, 1);
  advance(first, steps[0]);
  const Archive started = first.save();
  Simulation second(c, 1, &started);
  second.restore(started);
  second.use_device(first_device());
  advance(second, steps[1]);
  const Archive carried = second.save();
  Simulation third(c, 1, &carried);
  third.restore(carried);
  advance(third, steps[2]);
  EXPECT_EQ(told_by(third), truth);
}

/// What a run stops with, after how many steps, and in what state.
struct Failure {
  std::string said;
  std::int64_t step = 0;
  Told told{};
};

inline Failure failure_of(const Case& c, bool on_device, Precision precision = Precision::full) {
  Simulation s(c, 1);
  if (on_device) s.use_device(first_device(), precision);
  try {
    advance(s, 2000);
    s.whole();
  } catch (const PhysicsError& error) {
    return {error.what(), s.clock().step, told_by(s)};
  }
  return {"nothing went wrong"};
}

inline void expect_the_same_failure(const std::string& text, const std::string& word, const Overrides& overrides = {}) {
  const Case c = case_of(text, overrides);
  const Failure on_cpu = failure_of(c, false), on_device = failure_of(c, true);
  EXPECT_NE(on_cpu.said.find(word), std::string::npos) << on_cpu.said;
  EXPECT_EQ(on_device.said, on_cpu.said);
  EXPECT_EQ(on_device.step, on_cpu.step);
  EXPECT_EQ(on_device.told, on_cpu.told);
}

}  // namespace scree::test
