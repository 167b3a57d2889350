// Cases for the tests of the engine, as texts of case files, and what they read of a running simulation.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "scree/app/simulation.h"
#include "scree/input/load.h"

namespace scree::test {

using Overrides = std::vector<std::string>;

/// A choice of laws with the keys of a material that they read.
struct LawChoice {
  std::string name;
  std::string contact;   // lines of [contact]
  std::string material;  // lines of every material, beyond density, restitution and stiffness or moduli
  bool hertz = false;
};

inline std::string material_text(const LawChoice& laws, const std::string& name, double stiffness, double restitution) {
  std::string text = "[[materials]]\nname = \"" + name + "\"\ndensity = 2000\n";
  text += "restitution = " + std::to_string(restitution) + "\n" + laws.material;
  text += laws.hertz ? "poisson = 0.3\nyoung = " + std::to_string(2e3 * stiffness) + "\n"
                     : "stiffness = " + std::to_string(stiffness) + "\n";
  return text;
}

/// A crowd of spheres of two materials and many sizes (3 to 6 mm) that rush about in a closed box with gravity.
inline std::string crowd_text(const LawChoice& laws, int count, double side = 0.03) {
  const std::string s = std::to_string(side);
  return "[simulation]\nend = 10\ntime_step = 2e-5\nmax_overlap = 0.9\n"
         "[domain]\nmin = [-0.001, -0.001, -0.001]\nmax = [" +
         std::to_string(side + 0.001) + ", " + std::to_string(side + 0.001) + ", " + std::to_string(side + 0.001) +
         "]\n[gravity]\ntype = \"uniform\"\nacceleration = [0.3, 0, -9.81]\n[contact]\n" + laws.contact +
         material_text(laws, "glass", 2000, 0.8) + material_text(laws, "rubber", 1000, 0.5) +
         "[[particles]]\nname = \"grains\"\nmaterial = \"glass\"\ninsert = \"random\"\ncount = " +
         std::to_string(count) + "\nregion_min = [0, 0, 0]\nregion_max = [" + s + ", " + s + ", " + s +
         "]\ndiameter = { distribution = \"uniform\", min = 3e-3, max = 6e-3 }\n"
         "effect_gap = 2e-4\nangular_velocity = [10, -20, 5]\nvelocity = { type = \"random\", deviation = 0.5 }\n"
         "[[particles]]\nname = \"pellets\"\nmaterial = \"rubber\"\ninsert = \"random\"\ncount = " +
         std::to_string(count / 3) + "\nregion_min = [0, 0, 0]\nregion_max = [" + s + ", " + s + ", " + s +
         "]\ndiameter = 3.5e-3\nvelocity = { type = \"random\", deviation = 0.5 }\n"
         "[[walls]]\nname = \"box\"\ntype = \"box\"\nmaterial = \"rubber\"\nmin = [0, 0, 0]\nmax = [" +
         s + ", " + s + ", " + s + "]\n";
}

inline Case case_of(const std::string& text, const Overrides& overrides = {}) {
  return parse_case(text, "test.toml", overrides);
}

/// SCREE_ISA for the life of the object.
class InstructionSet {
 public:
  explicit InstructionSet(const char* name) { ::setenv("SCREE_ISA", name, 1); }
  InstructionSet(const InstructionSet&) = delete;
  InstructionSet& operator=(const InstructionSet&) = delete;
  ~InstructionSet() { ::unsetenv("SCREE_ISA"); }
};

/// The instruction sets that this processor has.
inline std::vector<const char*> instruction_sets() {
  std::vector<const char*> sets = {"baseline"};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) sets.push_back("avx2");
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd"))
    sets.push_back("avx512");
#endif
  return sets;
}

inline void advance(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step();
}

/// What a run ends with, to the bit.
struct Outcome {
  std::string hash;
  std::int64_t contacts, impacts, impact_speed;
  auto operator<=>(const Outcome&) const = default;
};

inline Outcome outcome(const Case& c, Team team, int steps, double skin = 0) {
  Case own = c;
  own.simulation.skin = skin;
  Simulation s(own, team);
  advance(s, steps);
  return {s.state_hash(), s.tally().contacts, s.tally().impacts, s.tally().impact_speed};
}

/// Rows of the particles in the order of their ids.
inline std::vector<std::size_t> rows_by_id(const Particles& p) {
  std::vector<std::size_t> row(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) row[static_cast<std::size_t>(p.id[i])] = i;
  return row;
}

using Springs = std::array<double, 7>;  // slide x y z, roll x y z, twist

inline Springs springs_at(const Buffer<double>& slide, const Buffer<double>& roll, std::size_t c, double sign) {
  Springs out{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!slide.empty()) out[k] = sign * slide[4 * c + k];
    if (!roll.empty()) out[3 + k] = sign * roll[4 * c + k];
  }
  if (!roll.empty()) out[6] = roll[4 * c + 3];
  return out;
}

/// Springs of all acting pairs by (lower id, higher id); directions are those from the lower id to the higher. The
/// twist about the normal is the same from either side.
inline std::map<std::pair<std::int64_t, std::int64_t>, Springs> pair_springs(const ParticleSystem& s) {
  std::map<std::pair<std::int64_t, std::int64_t>, Springs> out;
  for (std::size_t c = 0; c < s.contacts.pairs.count; ++c) {
    if (!s.contacts.active[c]) continue;
    const std::int64_t a = s.particles.id[s.contacts.pairs.owner[c]], b = s.particles.id[s.contacts.pairs.partner[c]];
    out[{std::min(a, b), std::max(a, b)}] = springs_at(s.contacts.slide, s.contacts.roll, c, a < b ? 1 : -1);
  }
  return out;
}

/// Springs of all acting contacts with walls by (id, face).
inline std::map<std::pair<std::int64_t, std::int64_t>, Springs> wall_springs(const ParticleSystem& s) {
  std::map<std::pair<std::int64_t, std::int64_t>, Springs> out;
  const WallContacts& w = s.wall_contacts;
  for (std::size_t p = 0; p + 1 < w.first.size(); ++p)
    for (std::int32_t c = w.first[p]; c < w.first[p + 1]; ++c)
      if (w.active[c])
        out[{s.particles.id[p], w.wall[c]}] = springs_at(w.slide, w.roll, static_cast<std::size_t>(c), 1);
  return out;
}

}  // namespace scree::test
