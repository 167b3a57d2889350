// Materials: unique names, references that lead somewhere, and properties that the chosen laws need or ignore.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "scree/input/checks.h"
#include "scree/input/suggest.h"

namespace scree {
namespace {

using PairMember = std::optional<double> PairKeys::*;

void unique_names(const Check& check, const char* list, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i].empty() && !seen.insert(names[i]).second)
      check.fail("E161", item_path(list, i) + ".name",
                 fmt::format("the name '{}' is taken twice in [[{}]]", names[i], list), "used above",
                 "names are unique within their list");
}

template <class T>
std::vector<std::string> names_of(const std::vector<T>& items) {
  std::vector<std::string> names;
  for (const T& item : items) names.push_back(item.name);
  return names;
}

void material_exists(const Check& check, const std::string& path, const std::string& name) {
  const std::vector<std::string> names = names_of(check.c.materials);
  if (names.empty() && !check.sound({"materials"})) return;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!check.sound({item_path("materials", i) + ".name"})) return;
  if (name.empty() || !check.sound({path}) || std::find(names.begin(), names.end(), name) != names.end()) return;
  std::string help = did_you_mean(name, names);
  if (help.empty()) help = "add it as [[materials]] with this name";
  check.fail("E160", path, fmt::format("there is no material '{}'", name), "not a material of this case", help);
}

void references(const Check& check) {
  const Case& c = check.c;
  for (std::size_t i = 0; i < c.particles.size(); ++i)
    material_exists(check, item_path("particles", i) + ".material", c.particles[i].material);
  for (std::size_t i = 0; i < c.walls.size(); ++i)
    material_exists(check, item_path("walls", i) + ".material", c.walls[i].material);
  std::set<std::array<std::string, 2>> seen;
  for (std::size_t i = 0; i < c.pairs.size(); ++i) {
    std::array<std::string, 2> names = c.pairs[i].materials;
    const std::string path = item_path("pairs", i) + ".materials";
    for (const std::string& name : names) material_exists(check, path, name);
    std::sort(names.begin(), names.end());
    if (check.sound({path}) && !seen.insert(names).second)
      check.fail("E161", path, fmt::format("the pair '{}' and '{}' is described twice", names[0], names[1]),
                 "described above", "put both into one [[pairs]]");
  }
}

/// Which materials can meet which: particles meet everything, walls meet particles only.
std::map<std::string, std::set<std::string>> partners(const Case& c) {
  std::map<std::string, std::set<std::string>> met;
  for (const ParticleKeys& p : c.particles) {
    for (const ParticleKeys& q : c.particles) met[p.material].insert(q.material);
    for (const WallKeys& w : c.walls) {
      met[p.material].insert(w.material);
      met[w.material].insert(p.material);
    }
  }
  return met;
}

bool pair_has(const Case& c, const std::string& a, const std::string& b, PairMember member) {
  return std::any_of(c.pairs.begin(), c.pairs.end(), [&](const PairKeys& p) {
    const bool same = (p.materials[0] == a && p.materials[1] == b) || (p.materials[0] == b && p.materials[1] == a);
    return same && (p.*member).has_value();
  });
}

void needs(const Check& check, std::size_t material, const char* key, const std::string& why) {
  const std::string path = item_path("materials", material);
  if (check.sound({path + "." + key}))
    check.fail("E163", path, fmt::format("material '{}' needs '{}' {}", check.c.materials[material].name, key, why),
               fmt::format("'{}' is missing", key), fmt::format("add '{}'   (scree explain materials.{})", key, key));
}

void needs_density(const Check& check) {
  const Case& c = check.c;
  for (std::size_t i = 0; i < c.materials.size(); ++i) {
    const bool used = std::any_of(c.particles.begin(), c.particles.end(),
                                  [&](const ParticleKeys& p) { return p.material == c.materials[i].name; });
    if (used && c.materials[i].density == 0) needs(check, i, "density", "because particles are made of it");
  }
}

void needed_by_laws(const Check& check) {
  const Case& c = check.c;
  if (is_hard(c)) return needs_density(check);
  const sc_laws& laws = c.contact.laws;
  const bool springs = laws.normal == SC_NORMAL_LINEAR || laws.normal == SC_NORMAL_LINEAR_PLAIN;
  const bool tangential = laws.tangential >= SC_TANGENTIAL_STEP_SPRING && laws.tangential <= SC_TANGENTIAL_HISTORY;
  const bool elastic = laws.normal == SC_NORMAL_HERTZ || sc_tangential_grows(laws);
  const auto met = partners(c);
  for (std::size_t i = 0; i < c.materials.size(); ++i) {
    const MaterialKeys& m = c.materials[i];
    const auto found = met.find(m.name);
    if (found == met.end()) continue;
    const bool mixed = std::any_of(found->second.begin(), found->second.end(), [&](const std::string& other) {
      return !pair_has(c, m.name, other, &PairKeys::stiffness);
    });
    if (!m.stiffness && mixed && (springs || tangential))
      needs(check, i, "stiffness",
            springs ? "for the linear normal law" : "for the stiffness of the tangential spring");
    if (!m.young && elastic) needs(check, i, "young", "for contact.normal = 'hertz' or contact.tangential = 'mindlin'");
    if (!m.poisson && elastic)
      needs(check, i, "poisson", "for contact.normal = 'hertz' or contact.tangential = 'mindlin'");
  }
  needs_density(check);
}

void laws_agree(const Check& check) {
  const sc_laws& laws = check.c.contact.laws;
  const bool hertz = laws.normal == SC_NORMAL_HERTZ;
  // Hard collisions read none of them: checks_hard.cpp refuses what they have no form for.
  if (is_hard(check.c)) return;
  if (!check.sound({"contact.normal", "contact.tangential", "contact.cohesion"})) return;
  if (laws.cohesion == SC_COHESION_JKR && !hertz)
    check.fail("E164", "contact.cohesion", "cohesion = 'jkr' takes the place of Hertz's spring",
               "needs normal = 'hertz'", "set contact.normal = 'hertz', or choose cohesion = 'linear'");
  if (sc_tangential_grows(laws) && !hertz)
    check.fail("E164", "contact.tangential", "tangential = 'mindlin' takes its stiffness from a Hertzian contact",
               "needs normal = 'hertz'", "set contact.normal = 'hertz', or choose tangential = 'history'");
}

/// A property and the law that reads it.
struct Property {
  const char* key;
  double MaterialKeys::*material;
  PairMember pair;
  const char* law_key;
  bool active;    // the chosen law reads the property
  bool required;  // the chosen law does nothing if it is zero everywhere
};

std::vector<Property> properties(const Case& c) {
  const sc_laws& laws = c.contact.laws;
  return {{"friction", &MaterialKeys::friction, &PairKeys::friction, "tangential",
           laws.tangential != SC_TANGENTIAL_NONE || is_hard(c), false},
          {"rolling_friction", &MaterialKeys::rolling_friction, &PairKeys::rolling_friction, "rolling",
           laws.rolling != SC_ROLLING_NONE, laws.rolling != SC_ROLLING_NONE},
          {"twisting_friction", &MaterialKeys::twisting_friction, &PairKeys::twisting_friction, "twisting",
           laws.twisting != SC_TWISTING_NONE, laws.twisting != SC_TWISTING_NONE},
          {"cohesion_stiffness", &MaterialKeys::cohesion_stiffness, &PairKeys::cohesion_stiffness, "cohesion",
           laws.cohesion == SC_COHESION_LINEAR, laws.cohesion == SC_COHESION_LINEAR && !is_hard(c)},
          {"adhesion", &MaterialKeys::adhesion, &PairKeys::adhesion, "cohesion", laws.cohesion == SC_COHESION_JKR,
           laws.cohesion == SC_COHESION_JKR && !is_hard(c)}};
}

void property_and_law(const Check& check, const Property& p) {
  const Case& c = check.c;
  const std::string law = std::string("contact.") + p.law_key;
  if (!check.sound({law})) return;
  bool any = false, switched = check.origins.overridden(law);
  const auto look = [&](const std::string& path, bool positive) {
    any = any || positive || !check.sound({path});
    switched = switched || check.origins.overridden(path);
    if (!positive || p.active || check.origins.overridden(law)) return;
    if (is_hard(c) && p.law_key == std::string_view("cohesion"))
      check.fail("E164", path, fmt::format("'{}' has no effect on hard collisions", p.key),
                 "an impulse does not hold bodies together", fmt::format("remove '{}'", p.key));
    else
      check.fail("E164", path, fmt::format("'{}' has no effect with the chosen laws of contact", p.key),
                 fmt::format("no law of contact reads it"),
                 fmt::format("set {} to a law that reads it, or remove '{}'   (scree explain {})", law, p.key, law));
  };
  for (std::size_t i = 0; i < c.materials.size(); ++i)
    look(item_path("materials", i) + "." + p.key, c.materials[i].*p.material > 0);
  for (std::size_t i = 0; i < c.pairs.size(); ++i)
    look(item_path("pairs", i) + "." + p.key, (c.pairs[i].*p.pair).value_or(0) > 0);
  if (p.required && !any && !switched)
    check.fail("E163", law, fmt::format("{} needs a material with '{}' above 0", law, p.key), "acts on nothing",
               fmt::format("add '{}' to a material or a pair   (scree explain materials.{})", p.key, p.key));
}

void values_agree(const Check& check) {
  const Case& c = check.c;
  const bool linear = c.contact.laws.normal != SC_NORMAL_HERTZ && c.contact.laws.cohesion == SC_COHESION_LINEAR;
  for (std::size_t i = 0; i < c.materials.size(); ++i) {
    const MaterialKeys& m = c.materials[i];
    const std::string path = item_path("materials", i);
    if (m.friction_sliding.value_or(0) > m.friction)
      check.fail("E167", path + ".friction_sliding",
                 "'friction_sliding' is larger than 'friction', the coefficient at rest",
                 fmt::format("friction is {}", m.friction), "bodies do not grip better while they slide");
    if (linear && m.stiffness && m.cohesion_stiffness >= *m.stiffness)
      check.fail("E167", path + ".cohesion_stiffness",
                 "'cohesion_stiffness' must be below 'stiffness', or particles fall into each other",
                 fmt::format("stiffness is {} N/m", *m.stiffness), "lower it, or raise the stiffness");
  }
}

}  // namespace

void check_materials(const Check& check) {
  const Case& c = check.c;
  unique_names(check, "materials", names_of(c.materials));
  unique_names(check, "particles", names_of(c.particles));
  unique_names(check, "walls", names_of(c.walls));
  unique_names(check, "outlets", names_of(c.outlets));
  references(check);
  laws_agree(check);
  if (check.sound({"contact"})) needed_by_laws(check);
  for (const Property& p : properties(c)) property_and_law(check, p);
  values_agree(check);
}

}  // namespace scree
