// Walls: shapes that have an extent, meshes that can be read, motions that go somewhere.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "scree/base/error.h"
#include "scree/base/expression.h"
#include "scree/input/checks.h"
#include "scree/input/mesh_file.h"

namespace scree {
namespace {

double length_of(const Vec3& v) { return std::hypot(v[0], v[1], v[2]); }

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool has_direction(const Vec3& v) { return length_of(v) > 1e-100 && length_of(v) < 1e100; }

/// One wall under examination.
struct WallCheck {
  const Check& check;
  const WallKeys& wall;
  std::string path;

  void fail(const std::string& key, const std::string& message, const std::string& note,
            const std::string& help) const {
    check.fail("E165", path + "." + key, message, note, help);
  }
};

void check_block(const WallCheck& w) {
  const WallKeys& k = w.wall;
  int flat = 0, reversed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    flat += k.max[i] == k.min[i] ? 1 : 0;
    reversed += k.max[i] < k.min[i] ? 1 : 0;
  }
  const std::string note = fmt::format("min is {}", in_words(k.min));
  if (reversed > 0)
    w.fail("max", fmt::format("max is below min in wall '{}'", k.name), note,
           "'min' is the lower corner, 'max' the upper one");
  else if (k.type == "rectangle" && flat != 1)
    w.fail("max", fmt::format("the rectangle '{}' is flat along {} axes instead of one", k.name, flat), note,
           "min and max of a rectangle agree along exactly one axis; an inclined one is a 'plate'");
  else if (k.type == "box" && flat > 0)
    w.fail("max", fmt::format("the box '{}' has no volume", k.name), note, "a wall that is flat is a 'rectangle'");
}

void check_plate(const WallCheck& w) {
  const WallKeys& k = w.wall;
  const double a = length_of(k.edge_a), b = length_of(k.edge_b);
  if (!has_direction(k.edge_a) || !has_direction(k.edge_b))
    w.fail(has_direction(k.edge_a) ? "edge_b" : "edge_a",
           fmt::format("an edge of the plate '{}' has no length", k.name),
           fmt::format("edge_a is {} m long, edge_b {} m", a, b), "both edges start at 'corner'");
  else if (std::abs(dot(k.edge_a, k.edge_b)) > 1e-9 * a * b)
    w.fail("edge_b", fmt::format("the edges of the plate '{}' are not at right angles", k.name),
           fmt::format("the cosine of the angle between them is {:.3g}", dot(k.edge_a, k.edge_b) / (a * b)),
           "a parallelogram or any other quadrangle can be given as 'triangles'");
}

void check_round(const WallCheck& w) {
  const WallKeys& k = w.wall;
  const bool cone = k.type == "cone";
  const bool same = k.start == k.end;
  if (!cone && same)
    w.fail("end", fmt::format("the cylinder '{}' has no length", k.name), fmt::format("start is {}", in_words(k.start)),
           "a disc is a 'cone' with equal start and end and one radius 0");
  else if (cone && same && !has_direction(k.axis))
    w.fail("axis", fmt::format("the ring '{}' needs the direction of its axis", k.name),
           "start and end are the same point", "give 'axis', at right angles to the ring");
  else if (cone && same && k.start_radius == k.end_radius)
    w.fail("end_radius", fmt::format("the ring '{}' has no area", k.name),
           fmt::format("both radii are {} m", k.start_radius), "a disc has one radius 0");
  else if (cone && k.start_radius == 0 && k.end_radius == 0)
    w.fail("end_radius", fmt::format("the cone '{}' has no area", k.name), "both radii are 0 m",
           "one radius of a cone is above 0");
  else if (same && k.closed)
    w.fail("closed", fmt::format("the ring '{}' cannot be closed", k.name), "it has no inside", "leave 'closed' out");
}

void check_vertices(const WallCheck& w) {
  const std::vector<Vec3>& v = w.wall.vertices;
  if (v.empty() || v.size() % 3 != 0)
    return w.fail("vertices", fmt::format("the triangles of '{}' are not complete", w.wall.name),
                  fmt::format("{} corners, three make a triangle", v.size()), "list the corners triangle by triangle");
  for (std::size_t i = 0; i < v.size(); i += 3) {
    Vec3 a, b;
    for (int k = 0; k < 3; ++k) {
      a[k] = v[i + 1][k] - v[i][k];
      b[k] = v[i + 2][k] - v[i][k];
    }
    const Vec3 area{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    if (length_of(area) > 1e-12 * length_of(a) * length_of(b)) continue;
    return w.fail("vertices", fmt::format("triangle {} of '{}' has no area", i / 3, w.wall.name),
                  fmt::format("its corners are {}, {}, {}", in_words(v[i]), in_words(v[i + 1]), in_words(v[i + 2])),
                  "triangles are counted from 0");
  }
}

void check_mesh(const WallCheck& w) {
  if (w.wall.file.empty()) return;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(w.wall.file, ignored))
    return w.check.fail("E168", w.path + ".file", fmt::format("there is no file '{}'", w.wall.file), "not found",
                        "file names are relative to the case file");
  try {
    read_mesh(w.wall.file);
  } catch (const InputError& error) {
    w.check.fail("E172", w.path + ".file", fmt::format("the mesh of '{}' cannot be read", w.wall.name), error.what(),
                 "export the surface again, as STL or as OBJ");
  }
}

struct Sampled {
  double time, value;
};

/// The first of many instants from 0 to `last` at which a formula of t is not finite. A pole between them shows only
/// in the run, which then stops.
std::optional<Sampled> first_without_number(const std::string& text, double last) {
  constexpr int instants = 1000;
  Expression formula(text, {"t"});
  for (int k = 0; k <= instants && last > 0; ++k) {
    const double at[1] = {last * k / instants};
    const double value = formula(at);
    if (!std::isfinite(value)) return Sampled{at[0], value};
  }
  return {};
}

void check_motion(const WallCheck& w) {
  const MotionKeys& m = w.wall.motion;
  const auto fail = [&](const std::string& key, const std::string& message, const std::string& note,
                        const std::string& help) {
    w.check.fail("E173", w.path + ".motion." + key, message, note, help);
  };
  if ((m.type == "rotation" || m.type == "expression") && !has_direction(m.axis))
    fail("axis", fmt::format("the axis of wall '{}' has no direction", w.wall.name),
         fmt::format("its length is {}", length_of(m.axis)), "the wall turns right-handed about this direction");
  if (m.stop && *m.stop <= m.start)
    fail("stop", fmt::format("the motion of wall '{}' ends before it begins", w.wall.name),
         fmt::format("start is {} s", m.start), "'stop' is a time, not a duration");
  if (m.type != "expression") return;
  const std::array<std::pair<const char*, std::string>, 4> formulas{{{"displacement", m.displacement[0]},
                                                                     {"displacement", m.displacement[1]},
                                                                     {"displacement", m.displacement[2]},
                                                                     {"angle", m.angle}}};
  const double until = std::min(w.check.c.simulation.end, m.stop.value_or(w.check.c.simulation.end));
  for (const auto& [key, text] : formulas) {
    const std::string problem = expression_problem(text, {"t"});
    if (!problem.empty())
      return fail(key, fmt::format("'{}' is no formula of t", text), problem,
                  "all parts of a wall move together: x, y, z do not appear");
    const double at_start[1] = {0.0};
    if (std::abs(Expression(text, {"t"})(at_start)) > 1e-12)
      return fail(key, fmt::format("wall '{}' is not at its place when the motion starts", w.wall.name),
                  fmt::format("'{}' is {} at t = 0", text, Expression(text, {"t"})(at_start)),
                  "subtract the value at 0, or put the wall where it starts");
    if (const auto bad = first_without_number(text, until - m.start))
      return fail(key, fmt::format("the motion of wall '{}' is no finite number at all times of the run", w.wall.name),
                  fmt::format("'{}' is {} at t = {:.6g}", text, bad->value, bad->time),
                  "t counts from motion.start; end the motion before (motion.stop), or mend the formula");
  }
}

/// The normal of a wall that is flat; nothing for the others.
std::optional<Vec3> normal_of(const WallKeys& k) {
  if (k.type == "plane") return k.normal;
  if (k.type == "rectangle") {
    Vec3 flat{};
    for (std::size_t i = 0; i < 3; ++i) flat[i] = k.min[i] == k.max[i] ? 1 : 0;
    return flat;
  }
  if (k.type != "plate") return {};
  const Vec3 &a = k.edge_a, &b = k.edge_b;
  return Vec3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A surface slides in itself. Directions of inclined walls are written with two or three digits.
void check_conveyor(const WallCheck& w) {
  constexpr double written_exactly = 0.01;
  const Vec3& v = w.wall.motion.velocity;
  const std::optional<Vec3> normal = normal_of(w.wall);
  if (w.wall.motion.type != "surface" || !normal || !has_direction(v) || !has_direction(*normal)) return;
  const double share = std::abs(dot(v, *normal)) / (length_of(v) * length_of(*normal));
  if (share <= written_exactly) return;
  w.check.fail("E173", w.path + ".motion.velocity",
               fmt::format("the surface of wall '{}' cannot move out of itself", w.wall.name),
               fmt::format("{:.3g} of this velocity is across the wall", share),
               "a conveyor moves along its surface; a wall that goes to other places has motion.type = 'velocity'");
}

void check_wall(const WallCheck& w) {
  const WallKeys& k = w.wall;
  if (k.until && *k.until <= k.from)
    w.fail("until", fmt::format("wall '{}' is taken away before it appears", k.name),
           fmt::format("from is {} s", k.from), "'until' is a time, not a duration");
  if (k.type == "plane" && !has_direction(k.normal))
    w.fail("normal", fmt::format("the normal of wall '{}' has no direction", k.name),
           fmt::format("its length is {}", length_of(k.normal)),
           "give the direction from the plane towards the particles");
  if (k.type == "rectangle" || k.type == "box") check_block(w);
  if (k.type == "plate") check_plate(w);
  if (k.type == "cylinder" || k.type == "cone") check_round(w);
  if (k.type == "triangles") check_vertices(w);
  if (k.type == "mesh") check_mesh(w);
  check_motion(w);
  check_conveyor(w);
}

}  // namespace

void check_walls(const Check& check) {
  for (std::size_t i = 0; i < check.c.walls.size(); ++i) {
    const std::string path = item_path("walls", i);
    if (check.sound({path})) check_wall({check, check.c.walls[i], path});
  }
}

}  // namespace scree
