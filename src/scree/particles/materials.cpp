#include "scree/particles/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scree/base/error.h"
#include "scree/particles/restitution.h"

namespace scree {
namespace {

double geometric_mean(double a, double b) { return std::sqrt(a * b); }

double needed(const MaterialProperties& m, const std::optional<double>& value, const char* key, const char* law) {
  if (!value)
    throw InputError(fmt::format("material '{}' has no `{}`, which the {} law needs\n  = help: add {} = ... to it",
                                 m.name, key, law, key));
  return *value;
}

double effective_young(const MaterialProperties& a, const MaterialProperties& b) {
  const auto compliance = [](const MaterialProperties& m) {
    const double nu = needed(m, m.poisson, "poisson", "Hertz");
    return (1 - nu * nu) / needed(m, m.young, "young", "Hertz");
  };
  return 1 / (compliance(a) + compliance(b));
}

double effective_shear(const MaterialProperties& a, const MaterialProperties& b) {
  const auto compliance = [](const MaterialProperties& m) {
    const double nu = needed(m, m.poisson, "poisson", "Mindlin");
    return (2 - nu) * 2 * (1 + nu) / needed(m, m.young, "young", "Mindlin");
  };
  return 1 / (compliance(a) + compliance(b));
}

double damping_ratio(int normal_law, double restitution) {
  if (normal_law == SC_NORMAL_HERTZ) return damping_for_restitution_hertz(restitution);
  if (normal_law == SC_NORMAL_LINEAR_PLAIN) return damping_for_restitution_plain(restitution);
  return damping_for_restitution_linear(restitution);
}

bool uses_moduli(const sc_laws& laws) {
  return laws.normal == SC_NORMAL_HERTZ || sc_tangential_grows(laws) || laws.cohesion == SC_COHESION_JKR;
}

bool uses_springs(const sc_laws& laws) {
  const bool tangential_spring =
      laws.tangential != SC_TANGENTIAL_NONE && laws.tangential != SC_TANGENTIAL_SLIDING && !sc_tangential_grows(laws);
  return laws.normal != SC_NORMAL_HERTZ || tangential_spring;
}

void mix_stiffness(sc_pair_law& law, const MaterialProperties& a, const MaterialProperties& b,
                   const PairProperties& own, const ContactSettings& settings) {
  if (uses_moduli(settings.laws)) {
    law.young = effective_young(a, b);
    law.shear = effective_shear(a, b);
    if (own.young) {
      law.shear *= *own.young / law.young;
      law.young = *own.young;
    }
  }
  if (!uses_springs(settings.laws)) return;
  if (own.stiffness) {
    law.stiffness = *own.stiffness;
  } else {
    const double ka = needed(a, a.stiffness, "stiffness", "linear"), kb = needed(b, b.stiffness, "stiffness", "linear");
    law.stiffness = 2 * ka * kb / (ka + kb);
  }
  law.tangential_stiffness = settings.tangential_stiffness_ratio * law.stiffness;
}

struct Frictions {
  double fixed = 0, sliding = 0;
};

Frictions frictions_of(const MaterialProperties& a, const MaterialProperties& b, const PairProperties& own) {
  const double mixed_sliding =
      geometric_mean(a.friction_sliding.value_or(a.friction), b.friction_sliding.value_or(b.friction));
  return {own.friction.value_or(geometric_mean(a.friction, b.friction)),
          own.friction_sliding.value_or(own.friction.value_or(mixed_sliding))};
}

double rolling_friction_of(const MaterialProperties& a, const MaterialProperties& b, const PairProperties& own) {
  return own.rolling_friction.value_or(geometric_mean(a.rolling_friction, b.rolling_friction));
}

double twisting_friction_of(const MaterialProperties& a, const MaterialProperties& b, const PairProperties& own) {
  return own.twisting_friction.value_or(geometric_mean(a.twisting_friction, b.twisting_friction));
}

sc_pair_law mix(const MaterialProperties& a, const MaterialProperties& b, const PairProperties& own, double restitution,
                const ContactSettings& settings) {
  sc_pair_law law{};
  if (settings.hard) return law;
  mix_stiffness(law, a, b, own, settings);
  law.damping = damping_ratio(settings.laws.normal, restitution);
  law.tangential_damping = settings.tangential_damping.value_or(law.damping);
  const Frictions friction = frictions_of(a, b, own);
  law.friction_static = friction.fixed;
  law.friction_sliding = friction.sliding;
  law.rolling_stiffness = settings.rolling_stiffness_ratio;
  law.rolling_damping = settings.rolling_damping;
  law.rolling_friction = rolling_friction_of(a, b, own);
  law.twisting_stiffness = settings.twisting_stiffness_ratio;
  law.twisting_damping = settings.twisting_damping;
  law.twisting_friction = twisting_friction_of(a, b, own);
  law.cohesion_stiffness = own.cohesion_stiffness.value_or(geometric_mean(a.cohesion_stiffness, b.cohesion_stiffness));
  law.adhesion = own.adhesion.value_or(geometric_mean(a.adhesion, b.adhesion));
  return law;
}

sc_impact_law impact_of(const MaterialProperties& a, const MaterialProperties& b, const PairProperties& own) {
  const Frictions friction = frictions_of(a, b, own);
  sc_impact_law law{};
  law.restitution = own.restitution.value_or(geometric_mean(a.restitution, b.restitution));
  law.tangential_restitution =
      own.tangential_restitution.value_or(geometric_mean(a.tangential_restitution, b.tangential_restitution));
  law.friction_static = friction.fixed;
  law.friction = friction.sliding;
  return law;
}

sc_turn_law turning_of(const MaterialProperties& a, const MaterialProperties& b, const PairProperties& own,
                       const sc_laws& laws) {
  return {laws.rolling == SC_ROLLING_NONE ? 0 : rolling_friction_of(a, b, own),
          laws.twisting == SC_TWISTING_NONE ? 0 : twisting_friction_of(a, b, own)};
}

}  // namespace

Materials make_materials(const std::vector<MaterialProperties>& materials, const std::vector<PairProperties>& pairs,
                         const ContactSettings& settings) {
  Materials out;
  for (const MaterialProperties& m : materials) {
    out.names.push_back(m.name);
    out.density.push_back(m.density);
  }
  const int n = out.count();
  out.law.resize(out.names.size() * out.names.size());
  out.restitution.resize(out.law.size());
  out.impact.resize(out.law.size());
  out.turning.resize(out.law.size());
  for (int a = 0; a < n; ++a)
    for (int b = a; b < n; ++b) {
      const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const PairProperties& p) {
        return std::minmax(p.a, p.b) == std::minmax(a, b);
      });
      const PairProperties own = found == pairs.end() ? PairProperties{} : *found;
      const sc_impact_law impact = impact_of(materials[a], materials[b], own);
      const sc_turn_law turning = turning_of(materials[a], materials[b], own, settings.laws);
      const sc_pair_law law = mix(materials[a], materials[b], own, impact.restitution, settings);
      for (const std::size_t place : {out.index(a, b), out.index(b, a)}) {
        out.law[place] = law;
        out.restitution[place] = impact.restitution;
        out.impact[place] = impact;
        out.turning[place] = turning;
      }
    }
  return out;
}

}  // namespace scree
