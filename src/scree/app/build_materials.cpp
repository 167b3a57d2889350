#include "scree/app/build_materials.h"

#include <fmt/format.h>

#include "scree/base/error.h"
#include "scree/particles/materials.h"

namespace scree {
namespace {

MaterialProperties properties_of(const MaterialKeys& keys) {
  MaterialProperties m;
  m.name = keys.name;
  m.density = keys.density;
  m.young = keys.young;
  m.poisson = keys.poisson;
  m.stiffness = keys.stiffness;
  m.restitution = keys.restitution;
  m.tangential_restitution = keys.tangential_restitution;
  m.friction = keys.friction;
  m.friction_sliding = keys.friction_sliding;
  m.rolling_friction = keys.rolling_friction;
  m.twisting_friction = keys.twisting_friction;
  m.cohesion_stiffness = keys.cohesion_stiffness;
  m.adhesion = keys.adhesion;
  return m;
}

PairProperties properties_of(const Case& c, const PairKeys& keys) {
  PairProperties p;
  p.a = material_index(c, keys.materials[0]);
  p.b = material_index(c, keys.materials[1]);
  p.stiffness = keys.stiffness;
  p.young = keys.young;
  p.restitution = keys.restitution;
  p.tangential_restitution = keys.tangential_restitution;
  p.friction = keys.friction;
  p.friction_sliding = keys.friction_sliding;
  p.rolling_friction = keys.rolling_friction;
  p.twisting_friction = keys.twisting_friction;
  p.cohesion_stiffness = keys.cohesion_stiffness;
  p.adhesion = keys.adhesion;
  return p;
}

}  // namespace

int material_index(const Case& c, const std::string& name) {
  for (std::size_t m = 0; m < c.materials.size(); ++m)
    if (c.materials[m].name == name) return static_cast<int>(m);
  throw InputError(fmt::format("there is no material '{}'\n  = help: add it to [[materials]]", name));
}

Materials build_materials(const Case& c) {
  std::vector<MaterialProperties> materials;
  for (const MaterialKeys& keys : c.materials) materials.push_back(properties_of(keys));
  std::vector<PairProperties> pairs;
  for (const PairKeys& keys : c.pairs) pairs.push_back(properties_of(c, keys));
  ContactSettings settings;
  settings.laws = c.contact.laws;
  settings.hard = is_hard(c);
  settings.tangential_stiffness_ratio = c.contact.tangential_stiffness_ratio;
  settings.tangential_damping = c.contact.tangential_damping;
  settings.rolling_stiffness_ratio = c.contact.rolling_stiffness_ratio;
  settings.rolling_damping = c.contact.rolling_damping;
  settings.twisting_stiffness_ratio = c.contact.twisting_stiffness_ratio;
  settings.twisting_damping = c.contact.twisting_damping;
  return make_materials(materials, pairs, settings);
}

}  // namespace scree
