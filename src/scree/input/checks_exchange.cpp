// Particles that come and go while the run goes on: rates, and where particles leave.
#include <fmt/format.h>

#include <algorithm>

#include "scree/input/checks.h"

namespace scree {
namespace {

void check_rate(const Check& check, std::size_t index) {
  const ParticleKeys& p = check.c.particles[index];
  const std::string path = item_path("particles", index);
  if (p.insert != "rate" || !check.sound({path})) return;
  if ((p.mass_rate > 0) == (p.number_rate > 0))
    check.fail("E169", path + ".insert", "insert = 'rate' needs either 'mass_rate' or 'number_rate'",
               p.mass_rate > 0 ? "both are given" : "neither is given", "say how fast particles come in in one way");
  if (p.motion != "free")
    check.fail("E164", path + ".motion", fmt::format("insert = 'rate' does not go with motion = '{}'", p.motion),
               "bodies of infinite mass are there from the start", "use motion = 'free', or another way to insert");
  if (p.until && *p.until <= p.from)
    check.fail("E167", path + ".until", fmt::format("the insertion of '{}' ends before it begins", p.name),
               fmt::format("'from' is {} s", p.from));
  if (p.from >= check.c.simulation.end && check.sound({"simulation.end"}))
    check.fail("E167", path + ".from", fmt::format("the insertion of '{}' begins after the end of the run", p.name),
               fmt::format("simulation.end is {} s", check.c.simulation.end));
}

void check_takeover(const Check& check, std::size_t index) {
  const ParticleKeys& p = check.c.particles[index];
  const std::string path = item_path("particles", index);
  if (p.insert == "checkpoint" && p.motion == "prescribed" && check.sound({path}))
    check.fail("E164", path + ".motion", "insert = 'checkpoint' does not go with motion = 'prescribed'",
               "where such bodies are is a matter of their formulas", "use motion = 'free' or 'fixed'");
}

void check_outlet(const Check& check, std::size_t index) {
  const OutletKeys& o = check.c.outlets[index];
  const std::string path = item_path("outlets", index);
  if (!check.sound({path, "domain"})) return;
  if (o.type == "region") {
    for (std::size_t k = 0; k < 3; ++k)
      if (!(o.max[k] > o.min[k])) {
        check.fail("E165", path + ".max", fmt::format("the region of outlet '{}' is empty along {}", o.name, "xyz"[k]),
                   fmt::format("min is ({}, {}, {})", o.min[0], o.min[1], o.min[2]), "'max' is the upper corner");
        return;
      }
    return;
  }
  const std::size_t axis = static_cast<std::size_t>(o.face[0] - 'x');
  if (check.c.domain.periodic[axis])
    check.fail("E164", path + ".face", fmt::format("the domain is periodic along {}: nobody leaves there", o.face[0]),
               "not a face that can be open",
               fmt::format("set domain.periodic to false along {}, or use type = 'region'", o.face[0]));
  for (std::size_t other = 0; other < index; ++other)
    if (check.c.outlets[other].type == "face" && check.c.outlets[other].face == o.face)
      check.fail("E161", path + ".face", fmt::format("the face {} is an outlet already", o.face),
                 fmt::format("it is '{}'", check.c.outlets[other].name));
}

}  // namespace

void check_exchange(const Check& check) {
  constexpr std::size_t most_outlets = 200;
  for (std::size_t i = 0; i < check.c.particles.size(); ++i) {
    check_rate(check, i);
    check_takeover(check, i);
  }
  for (std::size_t i = 0; i < check.c.outlets.size(); ++i) check_outlet(check, i);
  if (check.c.outlets.size() > most_outlets)
    check.fail("E164", item_path("outlets", most_outlets), fmt::format("more than {} outlets", most_outlets),
               fmt::format("there are {}", check.c.outlets.size()));
}

}  // namespace scree
