#include "scree/fluid/viscosity.h"

#include <algorithm>

#include "scree/fluid/fields.h"
#include "scree/fluid/halo.h"
#include "scree/fluid/turbulence.h"

namespace scree {

void make_viscosity(FluidSolver& s) {
  for (BoundaryFace& f : s.boundary) f.viscosity = s.settings.viscosity;
  if (!s.settings.viscosity_varies()) return;
  s.work.viscosity = s.mesh.make_field();
  if (s.settings.turbulence.model != TurbulenceSettings::Model::none) make_eddies(s);
}

void find_viscosity(FluidSolver& s, double dt) {
  FluidWork& w = s.work;
  if (w.viscosity.empty()) return;
  if (!w.eddies.empty()) find_eddies(s, dt);
  const auto& viscosity_of = s.settings.viscosity_of;
  const int t = s.settings.temperature;
  for_each_cell(s.mesh, [&](std::int64_t c, const auto&) {
    w.viscosity[c] = viscosity_of ? viscosity_of(s.state.scalars[t].value[c]) : s.settings.viscosity;
    if (w.eddies.empty()) return;
    // Eddies may give energy back, but no more than friction takes.
    w.eddies[c] = std::max(w.eddies[c], -w.viscosity[c]);
    w.viscosity[c] += w.eddies[c];
  });
  renew_ghosts(s.mesh, s.ranks, 1, {&w.viscosity});
  if (viscosity_of)
    for (std::size_t i = 0; i < s.boundary.size(); ++i)
      s.boundary[i].viscosity = viscosity_of(w.scalars[t].boundary[i].value);
}

}  // namespace scree
