#include "scree/particles/outlet.h"

namespace scree {

bool Outlet::takes(const double* x, const Domain& domain) const {
  if (is_face) return upper ? x[axis] >= domain.max[axis] : x[axis] < domain.min[axis];
  bool in = true;
  for (int k = 0; k < 3; ++k) in = in && x[k] >= min[k] && x[k] <= max[k];
  return in;
}

std::vector<std::uint8_t> find_leavers(const Particles& particles, const Domain& domain,
                                       const std::vector<Outlet>& outlets) {
  if (outlets.empty()) return {};
  const std::int64_t n = static_cast<std::int64_t>(particles.held());
  std::vector<std::uint8_t> taken(particles.held(), 0);
  std::int64_t leaving = 0;
#pragma omp parallel for schedule(static) reduction(+ : leaving)
  for (std::int64_t i = 0; i < n; ++i) {
    const double* m = particles.motion.row(static_cast<std::size_t>(i));
    if (m[lane::inverse_mass] == 0) continue;
    for (std::size_t o = 0; o < outlets.size() && !taken[i]; ++o)
      if (outlets[o].takes(m, domain)) taken[i] = static_cast<std::uint8_t>(o + 1);
    leaving += taken[i] != 0;
  }
  if (leaving == 0) taken.clear();
  return taken;
}

}  // namespace scree
