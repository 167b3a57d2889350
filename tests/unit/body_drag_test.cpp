// Drag, lift and torque of bodies that are no spheres: published tables, creeping flow, symmetry, crowding.
#include <gtest/gtest.h>

#include <cmath>

#include "scree/data/flow_shapes.h"
#include "scree/physics/drag/body/body.h"

namespace scree {
namespace {

TEST(BodyDrag, CylinderOfPublishedCorrelations) {
  // A cylinder of length 3 diameters: sphericity 0.778766; Ganser with d_n = d_V; Hoelzer and Sommerfeld with phi_perp
  // in place of phi_par, across and along the flow (reference table, computed independently).
  const double table[][5] = {{0.1, 261.015, 274.419, 288.518, 241.486},
                             {1, 31.1212, 32.0797, 32.2826, 26.8734},
                             {10, 4.849, 5.32335, 4.96712, 3.72021},
                             {100, 1.36983, 1.59868, 1.70053, 0.869843},
                             {1000, 1.3928, 1.23421, 1.20467, 0.415611}};
  const double phi = 0.778766, circle = M_PI * std::pow(9.0 / 16, 2.0 / 3);  // diameter 1, r_V^3 = 9/16
  for (const auto& row : table) {
    const double re = row[0], unit = 24 / re;
    EXPECT_NEAR(unit * sc_haider_levenspiel_factor(phi, re), row[1], 1e-5 * row[1]);
    EXPECT_NEAR(unit * sc_ganser_factor(phi, 1, re), row[2], 1e-5 * row[2]);
    const double side = 3 / circle, end = M_PI / 4 / circle;
    EXPECT_NEAR(unit * sc_holzer_sommerfeld_factor(phi, side, side, re), row[3], 1e-5 * row[3]);
    EXPECT_NEAR(unit * sc_holzer_sommerfeld_factor(phi, end, end, re), row[4], 1e-5 * row[4]);
  }
}

TEST(BodyDrag, SpheresAndEightTenths) {
  const auto hs = [](double p, double re) { return 24 / re * sc_holzer_sommerfeld_factor(p, 1 / p, 1 / p, re); };
  EXPECT_NEAR(hs(1, 1), 27.42, 1e-12);
  EXPECT_NEAR(hs(1, 10), 3.7686832981, 1e-10);
  EXPECT_NEAR(hs(1, 100), 0.96, 1e-12);
  EXPECT_NEAR(hs(1, 1000), 0.5388683298, 1e-10);
  EXPECT_NEAR(hs(.8, 100), 1.5583069825901, 1e-12);
  EXPECT_NEAR(24 * sc_ganser_factor(1, 1, 1), 26.6833302178, 1e-9);
  EXPECT_NEAR(.24 * sc_ganser_factor(1, 1, 100), .8047880466, 1e-10);
  EXPECT_NEAR(.24 * sc_ganser_factor(.8, 1, 100), 1.5204032306, 1e-9);
}

sc_body_stream stream_of(const FlowShape& f, sc_vec slip, double reynolds, double voidage = 1) {
  // A body of 1 mm in a fluid like air.
  sc_body_stream b{};
  b.slip = slip;
  b.diameter = 1e-3;
  b.voidage = voidage;
  b.viscosity = 1.8e-5;
  b.density = reynolds * b.viscosity / (sc_norm(slip) * b.diameter);
  b.shadow = f.shadow.data();
  b.mean = f.mean.data();
  return b;
}

TEST(BodyDrag, HoelzerSommerfeldOfEllipsoidsInCreepingFlow) {
  // Along an axis of a body of revolution: 1.007, 1.082, 1.294 of 2:1:1, 4:1:1, 1:1:1/4. Elsewhere the mean shadow
  // across the flow is a complete elliptic integral.
  const auto creeping = [](const FlowShape& f, sc_vec n) {
    return sc_body_drag_factor(SC_DRAG_HOLZER_SOMMERFELD, f.shape, stream_of(f, n, 1e-9), n, 0);
  };
  EXPECT_NEAR(creeping(make_flow_shape({2, 1, 1}, 1, 1), sc_make_vec(1, 0, 0)), 1.007, 5e-4);
  EXPECT_NEAR(creeping(make_flow_shape({4, 1, 1}, 1, 1), sc_make_vec(1, 0, 0)), 1.082, 5e-4);
  EXPECT_NEAR(creeping(make_flow_shape({1, 1, .25}, 1, 1), sc_make_vec(0, 0, 1)), 1.294, 5e-4);
  const FlowShape f = make_flow_shape({3, 2, 1}, 1, 1);
  const double circle = std::pow(6., 2. / 3), surface = 48.882146302582 / (2 * M_PI) / circle;
  // Shadows 2, 3, 6 along x, y, z over pi; across y they are between 2 and 6.
  const double mean = 6 * 2 / M_PI * std::comp_ellint_2(std::sqrt(1 - 1. / 9)) / circle;
  const double expected = std::sqrt(surface - mean) / 3 + 2 / (3 * std::sqrt(.8488424648));
  EXPECT_NEAR(creeping(f, sc_make_vec(0, 1, 0)), expected, 1e-9);
}

/// The coefficients C_D, C_L, C_T of the forces of a body of revolution about z, slip at an angle to z.
struct Coefficients {
  double drag, lift, torque;
};

Coefficients coefficients(int law, const FlowShape& f, double angle, double reynolds) {
  const sc_vec slip = sc_make_vec(.3 * std::sin(angle), 0, .3 * std::cos(angle));
  const sc_body_stream b = stream_of(f, slip, reynolds);
  const double pressure = .5 * b.density * .09, circle = M_PI / 4 * b.diameter * b.diameter;
  const sc_vec lift = sc_body_lift(law, f.shape, b), torque = sc_body_torque(law, f.shape, b);
  EXPECT_NEAR(sc_dot(lift, slip), 0, 1e-12 * sc_norm(lift));
  EXPECT_NEAR(lift.y, 0, 1e-15);
  EXPECT_NEAR(torque.x, 0, 1e-15);
  // The force leans from the flow away from the axis, and the torque turns the body broadside: both positive here.
  const double across = lift.x * std::cos(angle) - lift.z * std::sin(angle);
  return {sc_body_drag(law, f.shape, b) * .3 / (pressure * circle), across / (pressure * circle),
          -torque.y / (pressure * .5 * circle * b.diameter)};
}

TEST(BodyDrag, ZastawnysSpheroids) {
  struct Row {
    int law;
    double reynolds, degrees, drag, lift, torque;
  };
  // Reference table, computed independently from the printed coefficients.
  const Row rows[] = {{SC_DRAG_ZASTAWNY_5_2, .1, 45, 215.202, 23.3996, 2.18418},
                      {SC_DRAG_ZASTAWNY_5_2, 1, 0, 20.62, 0, 0},
                      {SC_DRAG_ZASTAWNY_5_2, 1, 30, 22.4325, 2.77933, 1.07569},
                      {SC_DRAG_ZASTAWNY_5_2, 10, 60, 4.18144, .628493, .62966},
                      {SC_DRAG_ZASTAWNY_5_2, 100, 45, 1.08295, .415502, .461879},
                      {SC_DRAG_ZASTAWNY_5_2, 300, 30, .540479, .29438, .333195},
                      {SC_DRAG_ZASTAWNY_5_2, 300, 90, 1.05514, 0, 0},
                      {SC_DRAG_ZASTAWNY_5_4, .1, 45, 208.561, 5.82654, .373993},
                      {SC_DRAG_ZASTAWNY_5_4, 1, 30, 22.8976, .713153, .225657},
                      {SC_DRAG_ZASTAWNY_5_4, 10, 90, 3.77381, 0, 0},
                      {SC_DRAG_ZASTAWNY_5_4, 100, 60, 1.04031, .107311, .10045},
                      {SC_DRAG_ZASTAWNY_5_4, 300, 45, .629042, .135273, .0964163}};
  for (const Row& r : rows) {
    const FlowShape f = make_flow_shape({1, 1, r.law == SC_DRAG_ZASTAWNY_5_2 ? 2.5 : 1.25}, 1, 1);
    const Coefficients c = coefficients(r.law, f, r.degrees * M_PI / 180, r.reynolds);
    EXPECT_NEAR(c.drag, r.drag, 5e-6 * r.drag);
    EXPECT_NEAR(c.lift, r.lift, 5e-6 * r.lift + 1e-12);
    EXPECT_NEAR(c.torque, r.torque, 5e-6 * r.torque + 1e-12);
  }
}

TEST(BodyDrag, GeneralModelsBesideZastawny) {
  // How far the models for any shape are from the two shapes that were simulated: measured, so that nobody has to
  // guess.
  for (const int law : {SC_DRAG_ZASTAWNY_5_2, SC_DRAG_ZASTAWNY_5_4}) {
    const FlowShape f = make_flow_shape({1, 1, law == SC_DRAG_ZASTAWNY_5_2 ? 2.5 : 1.25}, 1, 1);
    for (const double re : {.1, 1., 10., 100., 300.}) {
      const Coefficients truth = coefficients(law, f, M_PI / 4, re);
      const Coefficients general = coefficients(SC_DRAG_HOLZER_SOMMERFELD, f, M_PI / 4, re);
      EXPECT_NEAR(general.torque / truth.torque, 1.05, .35) << law << ' ' << re;
      EXPECT_NEAR(general.drag / truth.drag, 1.2, .25) << law << ' ' << re;
      EXPECT_NEAR(general.lift / truth.lift, .75, .3) << law << ' ' << re;
    }
  }
}

TEST(BodyDrag, TensorOfCreepingFlow) {
  const FlowShape f = make_flow_shape({3, 2, 1}, 1, 1);
  const sc_vec slip = sc_make_vec(.2, -.5, .3);
  const sc_body_stream b = stream_of(f, slip, 1);
  const double unit = 3 * M_PI * b.viscosity * b.diameter;
  const sc_vec force = sc_add_scaled(sc_body_lift(SC_DRAG_STOKES_ELLIPSOID, f.shape, b),
                                     sc_body_drag(SC_DRAG_STOKES_ELLIPSOID, f.shape, b), slip);
  EXPECT_NEAR(force.x, unit * f.shape.resistance.x * slip.x, 1e-14 * unit);
  EXPECT_NEAR(force.y, unit * f.shape.resistance.y * slip.y, 1e-14 * unit);
  EXPECT_NEAR(force.z, unit * f.shape.resistance.z * slip.z, 1e-14 * unit);
}

TEST(BodyDrag, SpheresFeelNoLiftAndNoTorque) {
  const FlowShape f = make_flow_shape({1, 1, 1}, 1, 1);
  for (const int law :
       {SC_DRAG_STOKES_ELLIPSOID, SC_DRAG_HAIDER_LEVENSPIEL, SC_DRAG_GANSER, SC_DRAG_HOLZER_SOMMERFELD}) {
    const sc_body_stream b = stream_of(f, sc_make_vec(.1, .2, -.3), 50);
    const double drag = sc_body_drag(law, f.shape, b) * sc_norm(b.slip);
    EXPECT_LT(sc_norm(sc_body_lift(law, f.shape, b)), 1e-13 * drag);
    EXPECT_LT(sc_norm(sc_body_torque(law, f.shape, b)), 1e-13 * drag * b.diameter);
    // Within 15 % of the standard drag, 1 + 0.15 Re^0.687 at Re = 50; Ganser's printed law is lower here.
    if (law != SC_DRAG_STOKES_ELLIPSOID) {
      EXPECT_NEAR(drag / (3 * M_PI * 1.8e-5 * 1e-3 * sc_norm(b.slip)) / 3.204, 1, law == SC_DRAG_GANSER ? .25 : .15)
          << law;
    }
    sc_body_stream still = b;
    still.slip = sc_zero_vec();
    EXPECT_TRUE(std::isfinite(sc_body_drag(law, f.shape, still)));
    EXPECT_EQ(sc_norm(sc_body_lift(law, f.shape, still)), 0);
  }
}

TEST(BodyDrag, CrowdingIsDiFelices) {
  // Whatever a body alone feels at the superficial velocity times e^-chi, continuous towards e = 1.
  const FlowShape f = make_flow_shape({1, 1, 2.5}, .5, 1);
  const sc_vec slip = sc_make_vec(.1, .05, .2);
  for (const int law : {SC_DRAG_STOKES_ELLIPSOID, SC_DRAG_GANSER, SC_DRAG_HOLZER_SOMMERFELD, SC_DRAG_ZASTAWNY_5_2}) {
    const double e = .55;
    const sc_body_stream crowd = stream_of(f, slip, 80, e);
    sc_body_stream alone = crowd;
    alone.voidage = 1;
    alone.slip = sc_scale(e, slip);
    const double factor = std::pow(e, -sc_di_felice_exponent(e * 80));
    EXPECT_NEAR(sc_body_drag(law, f.shape, crowd) / (sc_body_drag(law, f.shape, alone) * e * factor), 1, 1e-12);
    EXPECT_NEAR(sc_body_lift(law, f.shape, crowd).x / (sc_body_lift(law, f.shape, alone).x * factor), 1, 1e-11);
    EXPECT_NEAR(sc_body_torque(law, f.shape, crowd).y / (sc_body_torque(law, f.shape, alone).y * factor), 1, 1e-11);
    const double dilute = sc_body_drag(law, f.shape, stream_of(f, slip, 80, 1 - 1e-9));
    EXPECT_NEAR(dilute / sc_body_drag(law, f.shape, stream_of(f, slip, 80)), 1, 1e-8);
  }
}

}  // namespace
}  // namespace scree
