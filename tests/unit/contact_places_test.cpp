// Where a shape is hit decides how long the impact lasts: closed forms of ellipsoids and sharp boxes, and impacts that
// are run.
#include "scree/app/contact_places.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine_cases.h"
#include "scree/app/derived.h"
#include "scree/physics/touch/body_face.h"

namespace scree {
namespace {

double greatest_response(const Axes& axes, double e1, double e2) {
  return quickest_places(make_form(axes, e1, e2)).front().response;
}

// The arm of the support point of an ellipsoid of revolution turns about a diameter with
// (a^2 - c^2) n_x n_z / sqrt(a^2 n_x^2 + c^2 n_z^2), which is a - c at most; the moment is m (a^2 + c^2) / 5.
TEST(ContactPlaces, EllipsoidsAnswerWithFivePartsOfTheirUnevenness) {
  for (const double c : {0.05, 0.3, 0.9, 1.1, 3.0, 20.0}) {
    const double truth = 5 * (1 - c) * (1 - c) / (1 + c * c);
    EXPECT_NEAR(greatest_response({1, 1, c}, 1, 1) - 1, truth, 3e-3 * truth) << c;
  }
}

// A sharp flat box hit at a corner of its large face turns about both axes: 1 + 3 a^2/(a^2 + c^2) + 3 b^2/(b^2 + c^2).
TEST(ContactPlaces, FlatBoxesAnswerAsSharpOnesAlmost) {
  const double b = 0.7, c = 0.05, sharp = 1 + 3 / (1 + c * c) + 3 * b * b / (b * b + c * c);
  const double found = greatest_response({1, b, c}, 0.1, 0.1);
  EXPECT_LT(found, sharp);
  EXPECT_GT(found, 0.85 * sharp);
}

TEST(ContactPlaces, FlatFacesAnswerWithAllOfTheirMassAndTheLargestRadius) {
  const std::vector<ContactPlace> places = quickest_places(make_form({1, 1, 1}, 0.25, 0.25));
  EXPECT_NEAR(places.back().radius, 10, 1e-9);
  EXPECT_LT(places.front().radius, 2);
  for (std::size_t k = 1; k < places.size(); ++k) {
    EXPECT_LE(places[k].response, places[k - 1].response);
    EXPECT_GT(places[k].radius, places[k - 1].radius);
  }
}

TEST(ContactPlaces, TwoBodiesMeetAtTheWorstOfAllTheirPlaces) {
  const std::vector<ContactPlace> places{{4, 1}, {1.5, 3}, {1, 10}}, ball{{}};
  const HitBody body{&places, 2, 0.5}, sphere{&ball, 1, 0.25}, fixed{&places, 0, 0.5};
  EXPECT_DOUBLE_EQ(least_mass(body, nullptr), 1.0 / 8);
  EXPECT_DOUBLE_EQ(least_mass(body, &sphere), 1.0 / 9);
  EXPECT_DOUBLE_EQ(least_mass(sphere, &fixed), 1);
  // m^2/R against a wall: 1/64/0.5, 1/9/1.5, 1/4/5; between fixed and ball the flattest place counts.
  EXPECT_DOUBLE_EQ(quickest_hertz(body, nullptr).mass, 1.0 / 8);
  EXPECT_DOUBLE_EQ(quickest_hertz(sphere, &fixed).radius, 1 / (1 / 0.25 + 1 / 5.0));
  EXPECT_DOUBLE_EQ(quickest_hertz(fixed, &sphere).radius, 1 / (1 / 0.25 + 1 / 5.0));
}

/// A body on its way down to a plane that it is about to touch, turned about an axis in the plane.
struct Fall {
  Axes axes;
  double exponent = 1;
  bool hertz = false;
  double tilt = 0, across = 0;  // of the body, and the direction of the axis [rad]

  Case at(const std::string& time_step) const {
    const sc_mat turn = sc_quat_mat(sc_quat_of_turn(sc_make_vec(tilt * std::cos(across), tilt * std::sin(across), 0)));
    const double radius = bounding_radius(axes, exponent, exponent);
    const sc_form form = make_form(axes, exponent, exponent).shape;
    const double height = sc_support_in_world({form, radius, turn}, sc_make_vec(0, 0, -1)).value;
    return test::case_of(fmt::format(
        "[simulation]\nend = 1\ntime_step = {}\ntop_speed = 1\nmax_overlap = 0.5\n[domain]\nmin = [-1, -1, -1]\n"
        "max = [1, 1, 1]\n[contact]\nnormal = \"{}\"\ntangential = \"none\"\n"
        "[[materials]]\nname = \"glass\"\ndensity = 2500\nrestitution = 1\n{}\n"
        "[[walls]]\nname = \"floor\"\ntype = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
        "[[particles]]\nmaterial = \"glass\"\nshape = \"superellipsoid\"\nhalf_axes = [{}, {}, {}]\n"
        "exponents = [{}, {}]\ninsert = \"positions\"\npositions = [[0, 0, {:.17g}]]\nvelocity = [0, 0, -1]\n"
        "orientation = {{ axis = [{:.17g}, {:.17g}, 0], angle = {:.17g} }}\n",
        time_step, hertz ? "hertz" : "linear", hertz ? "young = 1e9\npoisson = 0.3" : "stiffness = 1e6", axes[0],
        axes[1], axes[2], exponent, exponent, height + 1e-5, std::cos(across), std::sin(across), tilt));
  }
};

/// How long it touches the plane the first time [s].
double duration(const Fall& fall, double time_step) {
  Simulation s(fall.at(fmt::format("{}", time_step)), Team{1});
  int touching = 0;
  for (int k = 0; k < 100000 && !(touching && s.findings().contacts == 0); ++k) {
    s.step();
    touching += s.findings().contacts > 0;
  }
  return touching * time_step;
}

// A disc of half axes a, c is hit hardest where tan^2 of the tilt is c/a; the impact lasts pi sqrt(m_c/k) with
// m_c = m / (1 + 5 (a - c)^2 / (a^2 + c^2)).
TEST(ContactPlaces, AutomaticStepsAreTwentyFiveInTheImpactOfADiscOnItsRim) {
  const Fall disc{{0.1, 0.1, 0.02}, 1, false, std::atan(std::sqrt(0.02 / 0.1)), 0.3};
  const double mass = 2500 * 4 * M_PI / 3 * 0.1 * 0.1 * 0.02, answer = 1 + 5 * 0.08 * 0.08 / (0.1 * 0.1 + 0.02 * 0.02);
  const double closed = M_PI * std::sqrt(mass / answer / 1e6);
  const DerivedStep automatic = derive(disc.at("\"auto\"")).step;
  EXPECT_NEAR(automatic.contact_time, closed, 2e-3 * closed);
  EXPECT_NEAR(automatic.time_step, closed / 25, 1e-3 * closed / 25);
  EXPECT_NE(automatic.shortest.find("where 0.25 of the mass answers"), std::string::npos) << automatic.shortest;
  EXPECT_NEAR(duration(disc, 5e-6), closed, 0.02 * closed);
}

// Brute force over tilts: none is shorter than promised, some are hardly longer.
TEST(ContactPlaces, NoImpactOfAPlateIsShorterThanPromised) {
  for (const bool hertz : {false, true}) {
    Fall plate{{0.1, 0.08, 0.02}, 0.25, hertz};
    const double promised = derive(plate.at("\"auto\"")).step.contact_time;
    double least = 1;
    for (int k = 0; k < 40; ++k) {
      plate.tilt = 1e-3 * std::pow(1.2, k);
      plate.across = 0.1 + 0.04 * k;
      least = std::min(least, duration(plate, promised / 200));
    }
    EXPECT_GT(least, 0.97 * promised) << hertz;
    EXPECT_LT(least, 1.15 * promised) << hertz;
  }
}

}  // namespace
}  // namespace scree
