#include "scree/particles/orientations.h"

#include "scree/particles/deviates.h"

namespace scree {
namespace {

/// Uniform over all rotations: a point on the unit sphere in four dimensions, from two circles.
sc_quat uniform_rotation(std::uint64_t seed, std::uint32_t stream, std::uint64_t count) {
  constexpr double two_pi = 6.283185307179586;
  const auto u = uniform_pair({seed, stream, count, 0});
  const double share = uniform({seed, stream, count, 1});
  const double first = std::sqrt(1 - share), second = std::sqrt(share);
  return sc_quat_of_length_one({first * sc_sin(two_pi * u[0]), first * sc_cos(two_pi * u[0]),
                                second * sc_sin(two_pi * u[1]), second * sc_cos(two_pi * u[1])});
}

}  // namespace

sc_quat draw_orientation(const Orientations& o, std::uint64_t seed, std::uint32_t group, std::uint64_t count) {
  const std::uint32_t stream = random_stream(Purpose::orientation, group);
  if (o.kind == Orientations::Kind::random) return uniform_rotation(seed, stream, count);
  if (o.kind == Orientations::Kind::given) return o.base;
  const auto xy = normal_pair({seed, stream, count, 0});
  const double z = normal({seed, stream, count, 1});
  return sc_quat_turned(o.base, {o.spread * xy[0], o.spread * xy[1], o.spread * z});
}

}  // namespace scree
