// Pairs of bodies whose growth distance and normal are known without any solver: the farthest points of both
// bodies along a common normal are brought together, so that the plane there separates them. All in long double.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "scree/data/forms.h"
#include "scree/physics/touch/certified.h"

namespace scree::pairs {

using Real = long double;
struct Vec {
  Real x, y, z;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(Real s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline Real dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Vec unit(Vec a) { return (1 / std::sqrt(dot(a, a))) * a; }
inline Vec wide(sc_vec v) { return {v.x, v.y, v.z}; }
inline sc_vec narrow(Vec v) {
  return sc_make_vec(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
}
inline Vec turn(const sc_mat& m, Vec v) { return {dot(wide(m.x), v), dot(wide(m.y), v), dot(wide(m.z), v)}; }
inline Vec turn_back(const sc_mat& m, Vec v) { return v.x * wide(m.x) + v.y * wide(m.y) + v.z * wide(m.z); }

/// A body at its centre, in its own frame.
struct Body {
  Form form;
  double radius = 1;

  Vec axes() const { return static_cast<Real>(radius) * wide(form.shape.axes); }

  /// (|x|^p + |y|^p)^(1/p) without loss.
  static Real norm(Real x, Real y, Real p) {
    const Real larger = std::max(x, y), smaller = std::min(x, y);
    return larger > 0 ? larger * std::pow(1 + std::pow(smaller / larger, p), 1 / p) : 0;
  }
  Real gauge(Vec x) const {
    if (form.other()) return capsule_gauge(x);
    const Vec a = axes();
    const Real n1 = 2 / static_cast<Real>(form.exponents[0]), n2 = 2 / static_cast<Real>(form.exponents[1]);
    return norm(norm(std::abs(x.x) / a.x, std::abs(x.y) / a.y, n2), std::abs(x.z) / a.z, n1);
  }
  Real support(Vec n) const {
    const Vec a = axes();
    if (form.other()) return a.x * std::sqrt(dot(n, n)) + (a.z - a.x) * std::abs(n.z);
    const Real q1 = 2 / (2 - static_cast<Real>(form.exponents[0])), q2 = 2 / (2 - static_cast<Real>(form.exponents[1]));
    return norm(norm(std::abs(n.x) * a.x, std::abs(n.y) * a.y, q2), std::abs(n.z) * a.z, q1);
  }
  /// The point that lies farthest along n.
  Vec farthest(Vec n) const {
    const Vec a = axes();
    if (form.other()) return a.x * unit(n) + Vec{0, 0, n.z == 0 ? 0 : std::copysign(a.z - a.x, n.z)};
    const Real q1 = 2 / (2 - static_cast<Real>(form.exponents[0])), q2 = 2 / (2 - static_cast<Real>(form.exponents[1]));
    const Real x = std::abs(n.x) * a.x, y = std::abs(n.y) * a.y, z = std::abs(n.z) * a.z;
    const Real r = norm(x, y, q2), h = norm(r, z, q1);
    const Real plane = r > 0 ? std::pow(r / h, q1 - 1) : 0;
    const auto part = [&](Real u) { return r > 0 ? std::pow(u / r, q2 - 1) : 0; };
    return {std::copysign(a.x * plane * part(x), n.x), std::copysign(a.y * plane * part(y), n.y),
            std::copysign(a.z * std::pow(z / h, q1 - 1), n.z)};
  }
  /// The only other shape so far: the least factor with which the segment and the radius come to the point, by halving.
  Real capsule_gauge(Vec x) const {
    const Vec a = axes();
    Real low = 0, high = std::sqrt(dot(x, x)) / a.x;
    for (int i = 0; i < 80; ++i) {
      const Real s = (low + high) / 2, beyond = std::max(std::abs(x.z) - s * (a.z - a.x), Real(0));
      (x.x * x.x + x.y * x.y + beyond * beyond > s * s * a.x * a.x ? low : high) = s;
    }
    return high;
  }
  /// Normal at the point of the surface along u: by differences of the gauge, which are good enough to choose a place.
  Vec normal_along(Vec u) const {
    const Real e = 1e-6L;
    return unit({gauge(u + Vec{e, 0, 0}) - gauge(u - Vec{e, 0, 0}), gauge(u + Vec{0, e, 0}) - gauge(u - Vec{0, e, 0}),
                 gauge(u + Vec{0, 0, e}) - gauge(u - Vec{0, 0, e})});
  }
};

/// Two bodies that just touch: A at the origin in its own frame.
struct Touching {
  Body a, b;  // a is not the smaller one, or no sphere where b is one
  sc_mat turn;
  Vec normal, branch;

  /// The pair with the branch times `growth`.
  sc_growth_pair at(double growth) const {
    return sc_make_growth_pair(a.form.shape, a.radius, b.form.shape, b.radius, turn, narrow(growth * branch));
  }
  Real support(Vec n) const { return a.support(n) + b.support(turn_back(turn, n)); }
  double larger_over_smaller() const { return std::max(a.radius, b.radius) / std::min(a.radius, b.radius); }
};

/// Touching along a normal in the frame of A.
inline Touching touching(const Body& a, const Body& b, const sc_mat& turn_b, Vec normal) {
  return {a, b, turn_b, normal, a.farthest(normal) + turn(turn_b, b.farthest(turn_back(turn_b, normal)))};
}

inline double normal_draw(std::mt19937_64& r) { return std::normal_distribution<double>()(r); }
inline double uniform_draw(std::mt19937_64& r) { return std::uniform_real_distribution<double>()(r); }
inline Vec any_direction(std::mt19937_64& r) {
  const double x = normal_draw(r), y = normal_draw(r), z = normal_draw(r);
  return unit({x, y, z});
}

inline sc_mat turn_of(double w, double x, double y, double z) {
  const double s = 2 / (w * w + x * x + y * y + z * z);
  sc_mat m;
  m.x = sc_make_vec(1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y));
  m.y = sc_make_vec(s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x));
  m.z = sc_make_vec(s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y));
  return m;
}
inline sc_mat any_turn(std::mt19937_64& r) {
  const double w = normal_draw(r), x = normal_draw(r), y = normal_draw(r), z = normal_draw(r);
  return turn_of(w, x, y, z);
}

/// A pair with a normal as it comes: any direction (corners and edges of blocky bodies), that of a place on one of the
/// surfaces (their faces), or a body that is almost parallel to the other.
inline Touching any_touching(const Body& a, const Body& b, std::mt19937_64& r) {
  const int way = static_cast<int>(4 * uniform_draw(r));
  sc_mat turn_b = any_turn(r);
  const double tilt = std::pow(10, -1 - 7 * uniform_draw(r));
  if (way == 3) {
    const double x = normal_draw(r), y = normal_draw(r), z = normal_draw(r);
    turn_b = turn_of(1, tilt * x, tilt * y, tilt * z);
  }
  Vec n = any_direction(r);
  if (way == 1 || way == 3) n = a.normal_along(n);
  if (way == 2) n = turn(turn_b, b.normal_along(n));
  return touching(a, b, turn_b, n);
}

/// Growth distance of two bodies at a branch, by looking for the least support value among all directions with n.d = 1,
/// in long double: convex in two unknowns, which two nested golden sections find whatever the shapes.
inline Real slow_growth(const Touching& t, Vec branch) {
  const Vec along = unit(branch);
  const Vec across = unit(std::abs(along.x) < 0.6L ? Vec{0, along.z, -along.y} : Vec{along.y, -along.x, 0});
  const Vec third = cross(along, across);
  // Over angles, whose tangents are the unknowns.
  const auto golden = [](auto f) {
    const Real ratio = (std::sqrt(5.0L) - 1) / 2;
    Real a = -1.5707963267948966L, b = -a, c = b - ratio * (b - a), d = a + ratio * (b - a), fc = f(std::tan(c)),
         fd = f(std::tan(d));
    for (int i = 0; i < 85; ++i) {
      if (fc < fd) {
        b = d, d = c, fd = fc, c = b - ratio * (b - a), fc = f(std::tan(c));
      } else {
        a = c, c = d, fc = fd, d = a + ratio * (b - a), fd = f(std::tan(d));
      }
    }
    return std::min(fc, fd);
  };
  const auto inner = [&](Real u) { return golden([&](Real v) { return t.support(along + u * across + v * third); }); };
  return std::sqrt(dot(branch, branch)) / golden(inner);
}

/// Two bodies and what to call them.
struct Kind {
  const char* name;
  Body a, b;
};

inline Body body(const Axes& axes, double n1, double n2, double size = 1) {
  return {make_form(axes, 2 / n1, 2 / n2), size};
}

/// Of a radius and half the length from tip to tip.
inline Body capsule(double radius, double half, double size = 1) {
  return {make_form("capsule", {radius, radius, half}, 1, 1), size};
}

/// The thirteen pairs of shapes of the method study, the extremes, pairs with a sphere, and capsules.
inline std::vector<Kind> kinds() {
  std::vector<Kind> all;
  const auto same = [&](const char* name, const Body& a) { all.push_back({name, a, a}); };
  same("sphere", body({1, 1, 1}, 2, 2));
  same("ellipsoid", body({1, .7, .5}, 2, 2));
  same("4,4", body({1, 1, 1}, 4, 4));
  same("8,2", body({1, 1, 1}, 8, 2));
  same("8,8", body({1, 1, 1}, 8, 8));
  same("20,20", body({1, 1, 1}, 20, 20));
  same("5.3,3.7", body({1, .8, .6}, 5.3, 3.7));
  same("plate", body({1, 1, .1}, 8, 8));
  same("rod", body({1, 1, 8}, 8, 2));
  same("pointed", body({1, 1, 1}, 1.3, 1.3));
  all.push_back({"cubes 1 : 0.04", body({1, 1, 1}, 8, 8), body({1, 1, 1}, 8, 8, .04)});
  all.push_back({"ellipsoid, cube", body({1, .7, .5}, 2, 2), body({1, 1, 1}, 8, 8)});
  all.push_back({"sphere, plate", body({1, 1, 1}, 2, 2), body({1, 1, .1}, 16, 4)});
  same("e 1.9", body({1, 1, 1}, 2 / 1.9, 2 / 1.9));
  all.push_back({"e 1.9, e 0.1", body({1, 1, 1}, 2 / 1.9, 2 / 1.9), body({1, 1, 1}, 20, 20)});
  same("needles 20", body({20, 1, 1}, 20, 20));
  same("discs 20", body({20, 20, 1}, 20, 2));
  all.push_back({"e 1.9 disc, small", body({20, 20, 1}, 2 / 1.9, 2 / 1.9), body({20, 20, 1}, 2 / 1.9, 2 / 1.9, .1)});
  same("capsules", capsule(1, 2.5));
  all.push_back({"capsule, capsule 20", capsule(1, 20), capsule(1, 1.1, .3)});
  all.push_back({"capsule, cube", capsule(1, 3), body({1, 1, 1}, 8, 8)});
  all.push_back({"ellipsoid, small capsule", body({1, .7, .5}, 2, 2), capsule(1, 4, .2)});
  all.push_back({"capsule, pointed", capsule(1, 2), body({1, 1, 1}, 1.3, 1.3, .8)});
  all.push_back({"needle, small cube", body({20, 1, 1}, 2, 2), body({1, 1, 1}, 20, 20, .1)});
  all.push_back({"box, sphere", body({1, .8, .6}, 8, 8), body({1, 1, 1}, 2, 2, .5)});
  all.push_back({"needle 20, large sphere", body({20, 1, 1}, 5.3, 3.7), body({1, 1, 1}, 2, 2, 10)});
  all.push_back({"e 1.9, sphere", body({1, 1, 1}, 2 / 1.9, 2 / 1.9), body({1, 1, 1}, 2, 2, .7)});
  all.push_back({"capsule, sphere", capsule(1, 3), body({1, 1, 1}, 2, 2, .4)});
  return all;
}

}  // namespace scree::pairs
