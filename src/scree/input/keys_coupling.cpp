// How particles and a fluid that is solved for act on each other.
#include "scree/input/force_keys.h"
#include "scree/input/keys.h"

namespace scree {

const Section& coupling_section() {
  using S = CouplingKeys;
  static const Section section = [] {
    Section all = {
        "coupling",
        "[coupling]",
        "How particles and a fluid that is solved for act on each other; with [fluid] and particles.",
        {key("drag", &S::drag,
             "none, or the law of the drag of a particle among others, from the void fraction, the velocity of the "
             "fluid between the particles and their diameter by volume; stokes and schiller_naumann are those of a "
             "particle alone. By the shape, crowded as by di_felice: haider_levenspiel, by its sphericity; by shape "
             "and orientation stokes_ellipsoid, ganser, holzer_sommerfeld, and zastawny for ellipsoids of 2:2:5 and "
             "4:4:5 (docs/fluid_forces.md)")
             .one_of({"none", "stokes", "schiller_naumann", "ergun", "wen_yu", "gidaspow", "gidaspow_blend",
                      "di_felice", "beetstra", "syamlal_obrien", "stokes_ellipsoid", "haider_levenspiel", "ganser",
                      "holzer_sommerfeld", "zastawny"}),
         key("subcycles", &S::subcycles,
             "time steps of the particles in one of the fluid; 0: as many as fit into fluid.time_step, or as "
             "fluid.courant allows at the speeds that the case gives, in liquids at most a quarter of the shortest "
             "contact, for beds at rest (docs/fluid.md)"),
         key("diffusion", &S::diffusion,
             "width of the bell (full width at half maximum) to which volume and forces of a particle are spread "
             "beyond the cells around it; 0: not at all; \"auto\": three of the largest diameters where cells are "
             "narrower than two, else 0")
             .unit("m")
             .at_least(0)
             .or_word("auto"),
         key("least_void_fraction", &S::least_void_fraction,
             "where particles overlap, solids beyond this go to the cells beside; the series counts these cells")
             .between(0.01, 0.99),
         key("pressure_force", &S::pressure_force,
             "whether the pressure gradient of the fluid acts on particles, buoyancy above all; only to see what it "
             "does"),
         key("viscous_stress", &S::viscous_stress,
             "whether the friction within the fluid acts on particles by their volume, as the pressure gradient does; "
             "else all of it acts on the fluid")},
        [] { return std::make_shared<S>(); }};
    for (Key& key : fluid_force_keys<S>()) all.keys.push_back(std::move(key));
    return all;
  }();
  return section;
}

}  // namespace scree
