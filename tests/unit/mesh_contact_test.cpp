// Walls of several faces: a sphere that goes over edges and corners touches the surface once, as if it had none.
#include <gtest/gtest.h>

#include <cmath>

#include "engine_cases.h"
#include "support/mesh_shapes.h"

namespace scree {
namespace {

using namespace test;

std::string triangles_text(const Triangles& triangles) {
  std::string text = "[[walls]]\ntype = \"triangles\"\nmaterial = \"steel\"\nvertices = [\n";
  for (const Corners& corners : triangles)
    for (const sc_vec& x : corners) text += fmt::format("[{:.17g}, {:.17g}, {:.17g}],\n", x.x, x.y, x.z);
  return text + "]\n";
}

std::string ball_text(const std::string& place, const std::string& velocity, const std::string& walls) {
  return "[simulation]\nend = 10\ntime_step = 1e-5\n[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n"
         "[gravity]\ntype = \"uniform\"\nacceleration = [0, 0, -9.81]\n[contact]\nrolling = \"spring\"\n"
         "[[materials]]\nname = \"steel\"\ndensity = 2000\nstiffness = 1e5\nrestitution = 0.5\nfriction = 0.3\n"
         "rolling_friction = 0.01\n[[particles]]\nmaterial = \"steel\"\ndiameter = 0.01\ninsert = \"positions\"\n"
         "positions = [" +
         place + "]\nvelocity = " + velocity + "\n" + walls;
}

/// The largest distance between the ball of two cases along the way, and how many contacts there were at most at once.
struct Difference {
  double position = 0;
  std::int64_t contacts = 0;
  double travelled = 0;
};

Difference compare(const Case& a, const Case& b, int steps) {
  Simulation one(a, {1, 1}), other(b, {1, 1});
  Difference out;
  const double start = one.system().particles.motion.row(0)[0];
  for (int k = 0; k < steps; ++k) {
    one.step();
    other.step();
    const double *x = one.system().particles.motion.row(0), *y = other.system().particles.motion.row(0);
    for (int axis = 0; axis < 3; ++axis) out.position = std::max(out.position, std::abs(x[axis] - y[axis]));
    out.contacts = std::max(out.contacts, other.findings().contacts);
    out.travelled = x[0] - start;
  }
  return out;
}

const std::string plane = "[[walls]]\ntype = \"plane\"\nmaterial = \"steel\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n";

TEST(Mesh, SphereRollsOverTrianglesAsOverAPlane) {
  // Slides at first, then rolls, over dozens of edges and some corners.
  const std::string start = "[0.05, 0.1, 0.00499]", velocity = "[0.8, 0.13, 0]";
  const Triangles triangles = plane_triangles(0.4, 80, 7);
  const Difference found = compare(case_of(ball_text(start, velocity, plane)),
                                   case_of(ball_text(start, velocity, triangles_text(triangles))), 40000);
  EXPECT_GT(found.travelled, 0.15);
  EXPECT_EQ(found.contacts, 1);
  EXPECT_LT(found.position, 1e-12);
}

TEST(Mesh, SphereThatStartsOnEdgesAndCornersTouchesOnce) {
  // A regular mesh, so that the ball runs exactly along an edge and over its ends.
  Triangles triangles;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 2; ++j) {
      const auto corner = [&](int di, int dj) { return sc_make_vec(0.005 * (i + di), 0.01 * (j + dj), 0); };
      add_quadrangle(triangles, corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
    }
  const std::string start = "[0.01, 0.01, 0.00499]", velocity = "[0.5, 0, 0]";
  const Difference found = compare(case_of(ball_text(start, velocity, plane)),
                                   case_of(ball_text(start, velocity, triangles_text(triangles))), 10000);
  EXPECT_GT(found.travelled, 0.03);
  EXPECT_EQ(found.contacts, 1);
  EXPECT_LT(found.position, 1e-12);
}

TEST(Mesh, OfABoxIsAsABoxFromOutside) {
  // Rolls off an edge, slowly enough to turn about it.
  const std::string start = "[0.09, 0.051, 0.10499]", velocity = "[0.15, 0.02, 0]";
  const std::string box =
      "[[walls]]\ntype = \"box\"\nside = \"outside\"\nmaterial = \"steel\"\nmin = [0, 0, 0]\nmax = [0.1, 0.1, 0.1]\n";
  const Triangles triangles = box_triangles(sc_make_vec(0, 0, 0), sc_make_vec(0.1, 0.1, 0.1));
  const Difference found = compare(case_of(ball_text(start, velocity, box)),
                                   case_of(ball_text(start, velocity, triangles_text(triangles))), 16000);
  EXPECT_GT(found.travelled, 0.015);
  EXPECT_EQ(found.contacts, 1);
  EXPECT_LT(found.position, 1e-12);
}

TEST(Mesh, OfABoxHoldsACrowdAsABoxDoes) {
  const LawChoice rough{"rough", "rolling = \"spring\"\n", "friction = 0.4\nrolling_friction = 0.1\n"};
  const std::string text = crowd_text(rough, 150);
  const std::string without = text.substr(0, text.find("[[walls]]"));
  std::string mesh = triangles_text(box_triangles(sc_make_vec(0, 0, 0), sc_make_vec(0.03, 0.03, 0.03)));
  mesh.replace(mesh.find("steel"), 5, "rubber");
  Simulation box(case_of(text), {1, 1}), triangles(case_of(without + mesh), {1, 1});
  double worst = 0;
  std::int64_t touching = 0;
  for (int k = 0; k < 400; ++k) {
    box.step();
    triangles.step();
    touching += static_cast<std::int64_t>(wall_springs(box.system()).size());
    EXPECT_EQ(box.findings().contacts, triangles.findings().contacts) << k;
  }
  const auto rows = rows_by_id(box.system().particles), others = rows_by_id(triangles.system().particles);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      worst = std::max(worst, std::abs(box.system().particles.motion.row(rows[i])[axis] -
                                       triangles.system().particles.motion.row(others[i])[axis]));
  EXPECT_GT(touching, 1000);
  EXPECT_LT(worst, 1e-10);
}

TEST(RoundWall, ClosedCylinderTouchesOnceAtItsRim) {
  const std::string drum =
      "[[walls]]\ntype = \"cylinder\"\nmaterial = \"steel\"\nstart = [0, 0, -0.1]\nend = [0, 0, 0]\nradius = "
      "0.05\nclosed = true\n";
  Simulation s(case_of(ball_text("[0.044, 0, 0.00499]", "[0.12, 0, 0]", drum)), {1, 1});
  bool beyond = false;
  for (int k = 0; k < 20000; ++k) {
    s.step();
    ASSERT_LE(s.findings().contacts, 1) << k;
    const double* m = s.system().particles.motion.row(0);
    // On the rim its surface is no nearer than its depth allows.
    const double out = m[0] - 0.05;
    if (out > 0 && m[2] > 0) {
      ASSERT_GT(std::hypot(out, m[2]), 0.0049);
      beyond = true;
    }
  }
  EXPECT_TRUE(beyond);
}

TEST(RoundWall, FineMeshOfADrumIsAsTheDrum) {
  const std::string start = "[0.02, 0.05, -0.08]", velocity = "[0, 0, 0]";
  const std::string drum =
      "[[walls]]\ntype = \"cylinder\"\nmaterial = \"steel\"\nstart = [0, 0, 0]\nend = [0, 0.1, 0]\nradius = 0.1\n";
  Triangles triangles = cylinder_triangles(0.1, 0.1, 2000);
  for (Corners& corners : triangles)
    for (sc_vec& x : corners) x = sc_make_vec(x.x, x.z, -x.y);
  const Difference found = compare(case_of(ball_text(start, velocity, drum)),
                                   case_of(ball_text(start, velocity, triangles_text(triangles))), 20000);
  // Facets lie up to 1.2e-7 m inside.
  EXPECT_LT(found.position, 1e-4);
}

}  // namespace
}  // namespace scree
