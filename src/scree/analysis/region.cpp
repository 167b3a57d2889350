#include "scree/analysis/region.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scree/base/exact_sum.h"
#include "scree/mpi/together.h"
#include "scree/particles/shapes.h"
#include "scree/particles/sizes.h"

namespace scree {
namespace {

constexpr double pi = 3.141592653589793;
constexpr int rings = 16, spokes = 32;

/// The part of the line from `from` to `from + way` that is in the box, as an interval of [0, 1]; empty if begin > end.
struct Piece {
  double begin = 0, end = 1;
};

Piece piece_in(const Region& box, const sc_vec& from, const sc_vec& way) {
  Piece out;
  const double x[3] = {from.x, from.y, from.z}, w[3] = {way.x, way.y, way.z};
  for (int k = 0; k < 3; ++k) {
    if (w[k] == 0) {
      if (x[k] < box.min[k] || x[k] > box.max[k]) out.end = -1;
      continue;
    }
    const double a = (box.min[k] - x[k]) / w[k], b = (box.max[k] - x[k]) / w[k];
    out.begin = std::max(out.begin, std::min(a, b));
    out.end = std::min(out.end, std::max(a, b));
  }
  return out;
}

/// Share of a body's volume that lies in the box.
double share_in(const Region& box, const sc_vec& centre, const sc_body_shape& body, const FormCones& cones) {
  double sum = 0;
  for (std::size_t k = 0; k < cones.tips.size(); ++k) {
    const Piece p = piece_in(box, centre, sc_turn(body.turn, sc_scale(body.radius, cones.tips[k])));
    if (p.begin < p.end) sum += cones.shares[k] * (p.end * p.end * p.end - p.begin * p.begin * p.begin);
  }
  return sum;
}

/// How the sphere of a radius about a place lies to the box.
enum class Lies { outside, across, inside };

Lies lies(const Region& box, const std::array<double, 3>& x, double radius) {
  Lies out = Lies::inside;
  for (int k = 0; k < 3; ++k) {
    if (x[k] + radius <= box.min[k] || x[k] - radius >= box.max[k]) return Lies::outside;
    if (x[k] - radius < box.min[k] || x[k] + radius > box.max[k]) out = Lies::across;
  }
  return out;
}

/// The box and the forms' cones, which are made when a body first needs them.
class Cutter {
 public:
  Cutter(const Region& box, const Forms& forms) : box_(box), forms_(forms.empty() ? Forms{sphere_form()} : forms) {
    cones_.resize(forms_.size());
  }

  /// Share of particle i, with its centre at x, that is in the box.
  double share(const Particles& particles, std::size_t i, const std::array<double, 3>& x) {
    const double radius = particles.motion.row(i)[lane::radius];
    const Lies where = lies(box_, x, radius);
    if (where != Lies::across) return where == Lies::inside ? 1 : 0;
    const auto form = static_cast<std::size_t>(is_sphere(particles, i) ? 0 : particles.form[i]);
    if (cones_[form].tips.empty()) cones_[form] = cut_into_cones(forms_[form].shape);
    const sc_body_shape body =
        form == 0 ? sc_body_shape{forms_[0].shape, radius, sc_unit_mat()} : body_shape(particles, i, forms_);
    return share_in(box_, sc_make_vec(x[0], x[1], x[2]), body, cones_[form]);
  }

 private:
  const Region& box_;
  Forms forms_;
  std::vector<FormCones> cones_;
};

}  // namespace

// With x = A d/gauge(A d), A the half axes and d of length one, the cone about d has a volume in proportion to
// gauge(A d)^-3. The directions d are the middles of equal areas: `rings` of equal height, each with `spokes`.
FormCones cut_into_cones(const sc_form& form) {
  FormCones out;
  double sum = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < spokes; ++j) {
      const double z = (2 * i + 1.0) / rings - 1, across = std::sqrt(1 - z * z), angle = pi * (2 * j + 1) / spokes;
      const sc_vec d =
          sc_make_vec(form.axes.x * across * sc_cos(angle), form.axes.y * across * sc_sin(angle), form.axes.z * z);
      const double gauge = sc_gauge(form, 1, d).value;
      out.tips.push_back(sc_scale(1 / gauge, d));
      out.shares.push_back(1 / (gauge * gauge * gauge));
      sum += out.shares.back();
    }
  for (double& share : out.shares) share /= sum;
  return out;
}

double solid_fraction(const Region& region, const Particles& particles, const Forms& forms, const Domain& domain,
                      const Ranks& ranks) {
  Cutter cutter(region, forms);
  ExactSum sum;
  const auto images = [&](int axis) { return domain.periodic[axis] ? 1 : 0; };
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double* m = particles.motion.row(i);
    double share = 0;
    for (int a = -images(0); a <= images(0); ++a)
      for (int b = -images(1); b <= images(1); ++b)
        for (int c = -images(2); c <= images(2); ++c)
          share += cutter.share(
              particles, i, {m[0] + a * domain.period(0), m[1] + b * domain.period(1), m[2] + c * domain.period(2)});
    if (share > 0) sum.add(share * sphere_volume(2 * particles.radius_by_volume(i)));
  }
  add_up_sums(sum, ranks);
  double volume = 1;
  for (int k = 0; k < 3; ++k) volume *= region.max[k] - region.min[k];
  return sum.value() / volume;
}

bool has_centre_in(const Region& region, const double* motion) {
  bool inside = motion[lane::inverse_mass] != 0;
  for (int k = 0; k < 3; ++k) inside = inside && motion[k] >= region.min[k] && motion[k] < region.max[k];
  return inside;
}

double coordination_number(const Region& region, const Particles& particles, std::span<const std::int32_t> contacts,
                           const Ranks& ranks) {
  std::int64_t there = 0, sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!has_centre_in(region, particles.motion.row(i))) continue;
    ++there;
    sum += contacts[i];
  }
  there = ranks.total(there);
  sum = ranks.total(sum);
  return there > 0 ? static_cast<double>(sum) / static_cast<double>(there) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace scree
