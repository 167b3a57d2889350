// What of a body is in a box, beside closed forms; packings whose density and contacts are known.
#include "scree/analysis/region.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_by_hand.h"
#include "scree/physics/rotation.h"

namespace scree {
namespace {

using namespace test;

constexpr double pi = 3.141592653589793;
const Domain open_space = {{-10, -10, -10}, {10, 10, 10}, {false, false, false}, {}};

/// One body of bounding radius 1 at a place.
struct OneBody {
  Forms forms{sphere_form()};
  Particles particles{true};

  OneBody(const Form& form, const sc_quat& turn, const std::array<double, 3>& x) {
    forms.push_back(form);
    set_grains(particles, {{x, {}, 1}});
    particles.form[0] = 1;
    const double q[4] = {turn.w, turn.x, turn.y, turn.z};
    std::copy_n(q, 4, particles.orientation.row(0));
    particles.inertia.row(0)[lane::radius_by_volume] = form.equivalent_radius;
  }

  double volume() const { return forms[1].volume; }

  /// Its volume in a box.
  double volume_in(const Region& box, const Domain& domain = open_space) const {
    double size = 1;
    for (int k = 0; k < 3; ++k) size *= box.max[k] - box.min[k];
    return size * solid_fraction(box, particles, forms, domain);
  }
};

/// Share of a sphere, or of an ellipsoid by the support function in place of the radius, below a plane that is `height`
/// times the radius above its centre.
double cap(double height) { return 0.25 * (height + 1) * (height + 1) * (2 - height); }

TEST(Region, OfASphereHasWhatAPlaneLeaves) {
  Particles p;
  for (const double height : {-0.95, -0.5, 0.0, 0.3, 0.77, 0.99}) {
    set_grains(p, {{{0.1, 0.2, 0}, {}, 2}});
    const Region below = {{-9, -9, -9}, {9, 9, 2 * height}};
    const double volume = 18 * 18 * (2 * height + 9) * solid_fraction(below, p, {}, open_space);
    EXPECT_NEAR(volume / sphere_volume(4), cap(height), 3e-3) << height;
  }
}

TEST(Region, OfATurnedEllipsoidHasWhatAPlaneLeaves) {
  const Form form = make_form({1, 0.8, 0.64}, 1, 1);
  for (const double turn : {0.3, 1.0, 2.2}) {
    const sc_quat q = sc_quat_of_turn(sc_make_vec(turn, 0.5 * turn, -0.2));
    const OneBody body(form, q, {0, 0, 0});
    const sc_vec up = sc_turn_back(sc_quat_mat(q), sc_make_vec(0, 0, 1));
    const double reach = sc_support(form.shape, 1, up).value;
    for (const double height : {-0.6, 0.0, 0.4, 0.9})
      EXPECT_NEAR(body.volume_in({{-2, -2, -2}, {2, 2, height * reach}}) / body.volume(), cap(height), 3e-3);
  }
}

/// A box of sharp edges with a corner of the region at its centre, and one of a slab that cuts it across.
TEST(Region, OfABoxHasWhatItsFacesLeave) {
  const Form form = make_form({1, 1, 1}, 0.1, 0.1);
  const OneBody body(form, sc_unit_quat(), {0.5, -0.5, 0});
  EXPECT_NEAR(body.volume_in({{0.5, -0.5, 0}, {3, 3, 3}}) / body.volume(), 0.125, 1e-12);
  EXPECT_NEAR(body.volume_in({{-3, -3, -0.2}, {3, 3, 0.2}}) / body.volume(), 0.2 / form.half_axes()[2], 0.02);
}

/// Cut by the faces of all cells of a lattice, a body of any place and turn is as large as it is.
TEST(Region, PartsOfABodyMakeTheWhole) {
  const OneBody body(make_form({1, 0.7, 0.5}, 0.4, 1.5), sc_quat_of_turn(sc_make_vec(0.3, 0.9, 0.4)),
                     {0.31, 0.13, 0.42});
  double sum = 0;
  for (int i = 0; i < 27; ++i) {
    const double x = i % 3 - 1.0, y = i / 3 % 3 - 1.0, z = i / 9 - 1.0;
    sum += body.volume_in({{x, y, z}, {x + 1, y + 1, z + 1}});
  }
  EXPECT_NEAR(sum / body.volume(), 1, 1e-12);
}

TEST(Region, WholeAcrossPeriodicFaces) {
  const Domain periodic = {{0, 0, 0}, {3, 3, 3}, {true, true, true}, {}};
  const OneBody body(make_form({1, 0.7, 0.5}, 1, 1), sc_quat_of_turn(sc_make_vec(0.3, 0.9, 0.4)), {0.1, 2.9, 0.2});
  EXPECT_NEAR(body.volume_in({{0, 0, 0}, {3, 3, 3}}, periodic) / body.volume(), 1, 1e-12);
  const double part = body.volume_in({{0, 0, 0}, {1.5, 3, 3}}, periodic) / body.volume();
  EXPECT_GT(part, 0.5);
  EXPECT_LT(part, 0.7);
}

/// Face-centred cubic spheres that touch fill pi / sqrt(18), wherever a region of whole cells begins.
TEST(Region, OfTheDensestLattice) {
  std::vector<Grain> grains;
  const double a = std::sqrt(2.0);  // diameter 1
  for (int i = -1; i < 5; ++i)
    for (int j = -1; j < 5; ++j)
      for (int k = -1; k < 5; ++k)
        for (const auto& [x, y, z] : {std::array{0.0, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.5, 0.0, 0.5}, {0.0, 0.5, 0.5}})
          grains.push_back({{a * (i + x), a * (j + y), a * (k + z)}, {}, 0.5});
  Particles p;
  set_grains(p, grains);
  for (const double shift : {0.0, 0.17, 0.4})
    EXPECT_NEAR(solid_fraction({{shift, shift / 2, -shift}, {shift + 3 * a, shift / 2 + 3 * a, 3 * a - shift}}, p, {},
                               open_space),
                pi / std::sqrt(18.0), 2e-4)
        << shift;
}

TEST(Region, CountsTheContactsOfThoseWhoseCentreIsInside) {
  Particles p;
  set_grains(p, {{{0.5, 0.5, 0.5}}, {{0.5, 0.5, 0.9}}, {{0.5, 0.5, 1}}, {{0.2, 0.2, 0.2}}});
  p.motion.row(3)[lane::inverse_mass] = 0;
  const std::vector<std::int32_t> contacts = {3, 6, 12, 12};
  EXPECT_EQ(coordination_number({{0, 0, 0}, {1, 1, 1}}, p, contacts), 4.5);
  EXPECT_TRUE(std::isnan(coordination_number({{0, 0, 2}, {1, 1, 3}}, p, contacts)));
}

}  // namespace
}  // namespace scree
