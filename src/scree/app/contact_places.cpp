#include "scree/app/contact_places.h"

#include <algorithm>
#include <limits>

#include "scree/physics/math.h"
#include "scree/physics/touch/contact_radius.h"
#include "scree/physics/touch/shape_contact.h"

namespace scree {
namespace {

/// The normal of a surface point with the angles of a superellipsoid's parameters, eta above the plane of x and y.
/// Faces and edges get their share of equal steps in these.
sc_vec normal_at(const Form& form, double eta, double omega) {
  const double e1 = form.exponents[0], e2 = form.exponents[1];
  const Axes a = form.half_axes();
  const auto power = [](double x, double e) { return sc_pow(std::max(x, 1e-12), 2 - e); };
  const double plane = power(sc_cos(eta), e1);
  const sc_vec n = sc_make_vec(plane * power(sc_cos(omega), e2) / a[0], plane * power(sc_sin(omega), e2) / a[1],
                               power(sc_sin(eta), e1) / a[2]);
  return sc_scale(1 / sc_norm(n), n);
}

ContactPlace place_at(const Form& form, const sc_vec& n) {
  const sc_vec turning = sc_cross(sc_support(form.shape, 1, n).gradient, n);
  const double by_volume = form.equivalent_radius;
  const sc_contact_radius bend =
      sc_contact_radius_of_wall({form.shape, 1, sc_unit_mat()}, n, SC_LEAST_CURVATURE_RADIUS * by_volume,
                                SC_LARGEST_CURVATURE_RADIUS * by_volume);
  const Axes& i = form.inertia;
  return {1 + (turning.x * turning.x / i[0] + turning.y * turning.y / i[1] + turning.z * turning.z / i[2]),
          bend.radius * bend.factor * bend.factor / by_volume};
}

/// Of every place of the one with every place of the other, or with a flat wall.
template <class Visit>
void at_all_places(const HitBody& a, const HitBody* b, Visit&& visit) {
  for (const ContactPlace& p : *a.places) {
    const double inverse_mass = p.response * a.inverse_mass, radius = p.radius * a.radius;
    if (!b) visit(ContactAt{1 / inverse_mass, radius});
    for (const ContactPlace& q : b ? *b->places : std::vector<ContactPlace>{})
      visit(
          ContactAt{1 / (inverse_mass + q.response * b->inverse_mass), 1 / (1 / radius + 1 / (q.radius * b->radius))});
  }
}

}  // namespace

std::vector<ContactPlace> quickest_of(std::vector<ContactPlace> places) {
  std::sort(places.begin(), places.end(), [](const ContactPlace& a, const ContactPlace& b) {
    return a.response > b.response || (a.response == b.response && a.radius > b.radius);
  });
  std::vector<ContactPlace> out;
  for (const ContactPlace& p : places)
    if (out.empty() || p.radius > out.back().radius) out.push_back(p);
  return out;
}

std::vector<ContactPlace> quickest_places(const Form& form) {
  if (form.shape.is_sphere) return {ContactPlace{}};
  constexpr int steps = 32;
  constexpr double quarter = 1.5707963267948966;
  std::vector<ContactPlace> places;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      places.push_back(place_at(form, normal_at(form, quarter * i / steps, quarter * j / steps)));
  return quickest_of(std::move(places));
}

double least_mass(const HitBody& first, const HitBody* second) {
  double least = std::numeric_limits<double>::infinity();
  at_all_places(first, second, [&](const ContactAt& c) { least = std::min(least, c.mass); });
  return least;
}

ContactAt quickest_hertz(const HitBody& first, const HitBody* second) {
  ContactAt best;
  double least = std::numeric_limits<double>::infinity();
  at_all_places(first, second, [&](const ContactAt& c) {
    const double time5 = c.mass * c.mass / c.radius;
    if (time5 >= least) return;
    least = time5;
    best = c;
  });
  return best;
}

}  // namespace scree
