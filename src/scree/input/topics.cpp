// Texts of the topics; the units come from their table.
#include "scree/input/topics.h"

#include <fmt/format.h>

#include "scree/base/units.h"

namespace scree {
namespace {

std::string units_text() {
  std::string out =
      "A number is in SI units. A text is a number with a unit: \"1.2 mm\", \"2.5 g/cm3\", \"300 rpm\", \"50 mJ/m2\".\n"
      "Units are multiplied by a space, * or ·, divided by /, and raised by a number (m2, m^2, s-1). A product after "
      "a\n"
      "division stands in parentheses: \"W/(m K)\". Angles are a dimension: angular velocities are in rad/s, deg/s or "
      "rpm.\n\n"
      "Unit      Name                              In SI base units (* takes prefixes: u or µ, m, c, k, M, G, ...)\n";
  for (const UnitName& unit : known_units()) {
    const std::string symbol = unit.symbol + (unit.prefixes ? " *" : "");
    out += fmt::format("{:<9} {:<33} {}\n", symbol, unit.name, unit.si);
  }
  return out;
}

}  // namespace

std::vector<Topic> topics() {
  return {
      {"units", units_text()},
      {"formulas",
       "A formula is a text such as \"9.81 * sin(2 * pi * t)\", in SI units, with angles in radians. Components of "
       "vectors\n"
       "are three formulas; a number may stand for a formula.\n\n"
       "Variables:  x, y, z (position) and t (time)      Constant:  pi\n"
       "Operators:  + - * / ^   < <= > >= == !=   && ||   condition ? a : b\n"
       "Functions:  sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp ln log log2 log10 sqrt cbrt\n"
       "            abs sign rint min max sum avg      (log is the natural logarithm)\n"},
      {"overrides",
       "--set KEY.PATH=VALUE changes a key for one run; it may be given several times. Tables in lists are found by "
       "name or\n"
       "by index from 0, and so are elements of lists. The value is TOML; what is not TOML counts as text.\n\n"
       "  --set simulation.end=0.5               --set materials.glass.restitution=0.5\n"
       "  --set particles.0.diameter=\"2 mm\"      --set particles.0.velocity.value=\"[1, 0, 0]\"\n"
       "  --set contact.normal=hertz             --set gravity.acceleration.2=-1.62\n"}};
}

}  // namespace scree
