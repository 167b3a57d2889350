// Adhesive contact of spheres (Johnson, Kendall and Roberts 1971), in place of the Hertz law.
#ifndef SCREE_PHYSICS_CONTACT_COHESION_JKR_H
#define SCREE_PHYSICS_CONTACT_COHESION_JKR_H

#include "scree/physics/contact/normal/hertz.h"
#include "scree/physics/math.h"

/// The scales of a contact. With s the root of the contact radius, x = s/root and d = overlap/length its equation is
/// x^4 - x = d, whatever the material.
typedef struct {
  real q;       // sqrt(2 pi W/E*) [m^(1/2)]
  real root;    // of the contact radius at no overlap, (q R)^(1/3) [m^(1/2)]
  real length;  // root^4/R [m]
  real broken;  // the overlap, negative, at which the neck breaks: -3/4 (pi^2 W^2 R/E*^2)^(1/3) [m]
  real force;   // E* root^2 length [N]
} sc_jkr;

SC_FN sc_jkr sc_jkr_scales_of(real young, real adhesion, real radius) {
  sc_jkr out;
  out.q = SC_SQRT(R(6.283185307179586477) * adhesion / young);
  out.root = sc_cbrt(out.q * radius);
  const real square = out.root * out.root;
  out.length = square * square / radius;
  out.broken = R(-0.47247039371057742) * out.length;
  out.force = young * square * out.length;
  return out;
}

/// The scales of a pair. No adhesion at all counts as 1e-20 E* R, which no force shows: the law is then that of Hertz.
SC_FN sc_jkr sc_jkr_scales(sc_pair_law p, real radius) {
  return sc_jkr_scales_of(p.young, SC_MAX(p.adhesion, R(1e-20) * p.young * radius), radius);
}

/// The overlap, negative, at which the neck breaks: -3/4 (pi^2 W^2 R/E*^2)^(1/3) [m].
SC_FN real sc_jkr_detachment(real young, real adhesion, real radius) {
  return sc_jkr_scales_of(young, adhesion, radius).broken;
}

/// Largest root of x^4 - x = d, d >= d_min, to round-off where it is simple.
///
/// With y = x - x_min the equation is 6 x_min^2 y^2 + 4 x_min y^3 + y^4 = d - d_min. Leaving out the last two terms, or
/// taking 1 + d^(1/4), gives bounds from above, from where Newton's method descends to the root without passing it.
SC_FN real sc_jkr_root(real d) {
  const real low = R(0.62996052494743658);  // x_min = 4^(-1/3)
  const real rest = SC_MAX(d + R(0.47247039371057742), R(0));
  const real near = SC_SQRT(rest * R(0.41997368329829105));  // 1/(6 x_min^2)
  const real far = R(1) - low + SC_SQRT(SC_SQRT(SC_MAX(d, R(0))));
  real y = SC_MIN(near, far);
  for (int i = 0; i < 6; ++i) {
    const real value = y * y * (R(2.3811015779522992) + y * (R(2.5198420997897463) + y)) - rest;
    const real slope = y * (R(4.7622031559045984) + y * (R(7.5595262993692390) + R(4) * y));
    y = slope > R(0) ? y - value / slope : y;
  }
  return low + y;
}

/// With the contact radius a = s^2 from delta = a^2/R - q sqrt(a), F = 4 E* a^3/(3 R) - 2 E* q a^(3/2). The first part
/// is the spring, on which friction acts; the second the attraction. Energies: elastic E* (8 a^5/(15 R^2) - 4 q
/// a^(7/2)/(3 R)
/// + q^2 a^2), adhesion -pi W a^2.
/// The contact begins at overlap 0 and, once `bonded`, holds down to the overlap `broken`.
SC_FN sc_normal sc_normal_jkr(sc_pair_law p, sc_touch t, sc_jkr c, int bonded) {
  sc_normal out;
  out.joined = (t.overlap > R(0)) | (bonded & (t.overlap > c.broken));
  const real s = out.joined ? c.root * sc_jkr_root(t.overlap / c.length) : R(0);
  const real a = s * s;
  const real indent = a * a / t.radius;  // the overlap that Hertz would need for this contact area
  const real pull = c.q * s;
  out.area_radius = a;
  out.spring = R(4.0 / 3.0) * p.young * a * indent;
  out.attraction = R(2) * p.young * a * pull;
  out.stiffness = R(2) * p.young * a;
  out.damping = sc_hertz_damping(p, a, t.mass);
  out.depth = indent - R(0.25) * pull;
  out.elastic = p.young * a * (R(8.0 / 15.0) * indent * indent - R(4.0 / 3.0) * indent * pull + pull * pull);
  out.cohesive = R(-0.5) * p.young * a * pull * pull;
  return out;
}

/// Energy lost by the two jumps [J]: what the surfaces release when the neck forms at overlap 0 (0.3 force length), and
/// what is left in it when it breaks (0.2 4^(-4/3) force length). The leapfrog's last kick reached half a step beyond
/// the last evaluation of the neck, so the energy left is that at that overlap.
SC_FN real sc_jkr_loss(sc_jkr c, sc_touch t, int begins, int breaks, real advance) {
  const real last = t.overlap - R(0.5) * advance;
  const real left = c.force * (R(0.031498026247371829) * c.length - R(5.0 / 12.0) * (last - c.broken));
  return begins ? R(0.3) * c.force * c.length : (breaks ? SC_MAX(left, R(0)) : R(0));
}

#endif
