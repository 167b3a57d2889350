// Constants of pairs of materials against hand-computed values and the documented rules of mixing.
#include "scree/particles/materials.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scree/base/error.h"

namespace scree {
namespace {

MaterialProperties soft() {
  MaterialProperties m;
  m.name = "soft";
  m.density = 1000;
  m.young = 1e7;
  m.poisson = 0.3;
  m.stiffness = 1000;
  m.restitution = 0.5;
  m.friction = 0.4;
  m.rolling_friction = 0.01;
  m.twisting_friction = 0.02;
  m.cohesion_stiffness = 30;
  m.adhesion = 0.05;
  return m;
}

MaterialProperties hard() {
  MaterialProperties m;
  m.name = "hard";
  m.density = 2500;
  m.young = 7e10;
  m.poisson = 0.25;
  m.stiffness = 4000;
  m.restitution = 0.8;
  m.friction = 0.9;
  m.friction_sliding = 0.1;
  m.rolling_friction = 0.04;
  m.twisting_friction = 0.08;
  m.cohesion_stiffness = 120;
  m.adhesion = 0.2;
  return m;
}

ContactSettings settings(int normal, int tangential, int cohesion = SC_COHESION_NONE) {
  ContactSettings s;
  s.laws = {normal, tangential, SC_ROLLING_SPRING, SC_TWISTING_SPRING, cohesion};
  return s;
}

// 1/E* = 0.91/1e7 + 0.9375/7e10; 1/G* = 1.7 * 2.6/1e7 + 1.75 * 2.5/7e10. Equal materials: physics of Hertz and Mindlin
// with E = 1e7, nu = 0.3 give E* = 5494505.4945 and G* = 1131221.7195.
TEST(Materials, EffectiveModuli) {
  const Materials m = make_materials({soft(), hard()}, {}, settings(SC_NORMAL_HERTZ, SC_TANGENTIAL_MINDLIN));
  EXPECT_NEAR(m.pair(0, 0).young, 5494505.4945, 1e-3);
  EXPECT_NEAR(m.pair(0, 0).shear, 1131221.7195, 1e-3);
  EXPECT_NEAR(m.pair(0, 1).young, 10987393.9275028, 1e-5);
  EXPECT_NEAR(m.pair(1, 0).shear, 2262123.5685, 1e-3);
  EXPECT_EQ(m.density[1], 2500);
  EXPECT_EQ(m.names[1], "hard");
  EXPECT_EQ(m.count(), 2);
}

TEST(Materials, SpringsAreInSeries) {
  ContactSettings s = settings(SC_NORMAL_LINEAR_PLAIN, SC_TANGENTIAL_HISTORY);
  s.tangential_stiffness_ratio = 0.25;
  const Materials m = make_materials({soft(), hard()}, {}, s);
  EXPECT_EQ(m.pair(0, 0).stiffness, 1000);
  EXPECT_EQ(m.pair(1, 1).stiffness, 4000);
  EXPECT_EQ(m.pair(0, 1).stiffness, 1600);
  EXPECT_EQ(m.pair(1, 0).tangential_stiffness, 400);
}

TEST(Materials, CoefficientsMixGeometrically) {
  const Materials m = make_materials({soft(), hard()}, {}, settings(SC_NORMAL_LINEAR, SC_TANGENTIAL_HISTORY));
  const sc_pair_law& law = m.pair(0, 1);
  EXPECT_NEAR(m.restitution[m.index(0, 1)], std::sqrt(0.4), 1e-15);
  EXPECT_NEAR(law.friction_static, 0.6, 1e-15);
  EXPECT_NEAR(law.friction_sliding, 0.2, 1e-15);
  EXPECT_NEAR(law.rolling_friction, 0.02, 1e-15);
  EXPECT_NEAR(law.twisting_friction, 0.04, 1e-15);
  EXPECT_NEAR(law.cohesion_stiffness, 60, 1e-12);
  EXPECT_NEAR(law.adhesion, 0.1, 1e-15);
  EXPECT_EQ(m.pair(0, 0).friction_static, 0.4);
  EXPECT_EQ(m.pair(0, 0).friction_sliding, 0.4);
  EXPECT_EQ(m.pair(1, 1).friction_sliding, 0.1);
  EXPECT_EQ(m.pair(0, 0).cohesion_stiffness, 30);
}

TEST(Materials, PairsOverride) {
  PairProperties own;
  own.a = 1;  // the other order than in the table
  own.b = 0;
  own.stiffness = 5000;
  own.young = 2e7;
  own.restitution = 0.5;
  own.friction = 0.3;
  own.rolling_friction = 0.7;
  own.cohesion_stiffness = 7;
  const Materials m = make_materials({soft(), hard()}, {own}, settings(SC_NORMAL_LINEAR_PLAIN, SC_TANGENTIAL_MINDLIN));
  for (const sc_pair_law* law : {&m.pair(0, 1), &m.pair(1, 0)}) {
    EXPECT_EQ(law->stiffness, 5000);
    EXPECT_EQ(law->young, 2e7);
    EXPECT_NEAR(law->shear, 2262123.5685 * 2e7 / 10987393.9275028, 1e-3);
    EXPECT_EQ(law->friction_static, 0.3);
    EXPECT_EQ(law->friction_sliding, 0.3);
    EXPECT_EQ(law->rolling_friction, 0.7);
    EXPECT_NEAR(law->twisting_friction, 0.04, 1e-15);
    EXPECT_EQ(law->cohesion_stiffness, 7);
    EXPECT_NEAR(law->damping, 0.215453762, 1e-9);
  }
  EXPECT_EQ(m.pair(0, 0).stiffness, 1000);
  EXPECT_EQ(m.pair(1, 1).stiffness, 4000);
}

// Damping ratios for a restitution of 0.5: -ln e/sqrt(ln^2 e + pi^2) with tension, 0.255275638 without.
TEST(Materials, DampingFollowsTheNormalLaw) {
  const auto damping = [](int normal) {
    return make_materials({soft()}, {}, settings(normal, SC_TANGENTIAL_NONE)).pair(0, 0).damping;
  };
  EXPECT_NEAR(damping(SC_NORMAL_LINEAR_PLAIN), 0.215453762, 1e-9);
  EXPECT_NEAR(damping(SC_NORMAL_LINEAR), 0.255275638, 1e-9);
  EXPECT_GT(damping(SC_NORMAL_HERTZ), 0.215453762);
  ContactSettings s = settings(SC_NORMAL_LINEAR_PLAIN, SC_TANGENTIAL_HISTORY);
  EXPECT_NEAR(make_materials({soft()}, {}, s).pair(0, 0).tangential_damping, 0.215453762, 1e-9);
  s.tangential_damping = 0.05;
  EXPECT_EQ(make_materials({soft()}, {}, s).pair(0, 0).tangential_damping, 0.05);
}

TEST(Materials, MissingConstantsAreRefusedByName) {
  MaterialProperties bare;
  bare.name = "bare";
  const auto message = [&](const ContactSettings& s) {
    try {
      make_materials({bare}, {}, s);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(message(settings(SC_NORMAL_LINEAR, SC_TANGENTIAL_NONE)).find("'bare' has no `stiffness`"),
            std::string::npos);
  EXPECT_NE(message(settings(SC_NORMAL_HERTZ, SC_TANGENTIAL_NONE)).find("'bare' has no `poisson`"), std::string::npos);
  bare.poisson = 0.2;
  EXPECT_NE(message(settings(SC_NORMAL_HERTZ, SC_TANGENTIAL_NONE)).find("'bare' has no `young`"), std::string::npos);
  bare.young = 1e9;
  EXPECT_EQ(message(settings(SC_NORMAL_HERTZ, SC_TANGENTIAL_MINDLIN)), "");
  EXPECT_NE(message(settings(SC_NORMAL_HERTZ, SC_TANGENTIAL_HISTORY)).find("`stiffness`"), std::string::npos);
}

}  // namespace
}  // namespace scree
