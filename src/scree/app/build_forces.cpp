#include "scree/app/build_forces.h"

#include "scree/app/models.h"

namespace scree {
namespace {

void choose(const std::string& word, int& force) {
  if (word != "auto") force = word == "on";
}

}  // namespace

FluidForces build_forces(const std::string& drag, const FluidForceKeys& k) {
  FluidForces f = body_forces(body_drag_law(drag));
  f.drag = drag_law(drag);
  choose(k.shape_lift, f.lift);
  choose(k.pitching_torque, f.pitching);
  choose(k.viscous_torque, f.viscous_turn);
  f.saffman = k.saffman;
  f.magnus = k.magnus;
  f.added_mass = k.added_mass;
  return f;
}

}  // namespace scree
