// The table of units.
#include "scree/base/unit_table.h"

namespace scree {
namespace {

constexpr double pi = 3.14159265358979323846;

//                                    m   kg  s  A  K mol rad
constexpr Dimension none{};
constexpr Dimension length{.power = {{1, 0, 0, 0, 0, 0, 0}}};
constexpr Dimension mass{.power = {{0, 1, 0, 0, 0, 0, 0}}};
constexpr Dimension time{.power = {{0, 0, 1, 0, 0, 0, 0}}};
constexpr Dimension current{.power = {{0, 0, 0, 1, 0, 0, 0}}};
constexpr Dimension temperature{.power = {{0, 0, 0, 0, 1, 0, 0}}};
constexpr Dimension amount{.power = {{0, 0, 0, 0, 0, 1, 0}}};
constexpr Dimension angle{.power = {{0, 0, 0, 0, 0, 0, 1}}};
constexpr Dimension frequency{.power = {{0, 0, -1, 0, 0, 0, 0}}};
constexpr Dimension turning{.power = {{0, 0, -1, 0, 0, 0, 1}}};
constexpr Dimension volume{.power = {{3, 0, 0, 0, 0, 0, 0}}};
constexpr Dimension force{.power = {{1, 1, -2, 0, 0, 0, 0}}};
constexpr Dimension pressure{.power = {{-1, 1, -2, 0, 0, 0, 0}}};
constexpr Dimension energy{.power = {{2, 1, -2, 0, 0, 0, 0}}};
constexpr Dimension power{.power = {{2, 1, -3, 0, 0, 0, 0}}};
constexpr Dimension voltage{.power = {{2, 1, -3, -1, 0, 0, 0}}};
constexpr Dimension viscosity{.power = {{-1, 1, -1, 0, 0, 0, 0}}};
constexpr Dimension diffusivity{.power = {{2, 0, -1, 0, 0, 0, 0}}};
constexpr Dimension acceleration{.power = {{1, 0, -2, 0, 0, 0, 0}}};

constexpr UnitRow units[] = {
    {"m", "metre", 1, 0, length, true},
    {"g", "gram", 1, -3, mass, true},
    {"s", "second", 1, 0, time, true},
    {"A", "ampere", 1, 0, current, true},
    {"K", "kelvin", 1, 0, temperature, true},
    {"mol", "mole", 1, 0, amount, true},
    {"rad", "radian", 1, 0, angle, true},
    {"Hz", "hertz", 1, 0, frequency, true},
    {"N", "newton", 1, 0, force, true},
    {"Pa", "pascal", 1, 0, pressure, true},
    {"J", "joule", 1, 0, energy, true},
    {"W", "watt", 1, 0, power, true},
    {"V", "volt", 1, 0, voltage, true},
    {"min", "minute", 60, 0, time, false},
    {"h", "hour", 3600, 0, time, false},
    {"d", "day", 86400, 0, time, false},
    {"deg", "degree", pi / 180, 0, angle, false},
    {"°", "degree", pi / 180, 0, angle, false},
    {"rev", "revolution", 2 * pi, 0, angle, false},
    {"rpm", "revolution per minute", pi / 30, 0, turning, false},
    {"L", "litre", 1, -3, volume, true},
    {"l", "litre", 1, -3, volume, true},
    {"t", "tonne", 1, 3, mass, false},
    {"bar", "bar", 1, 5, pressure, true},
    {"atm", "standard atmosphere", 101325, 0, pressure, false},
    {"mmHg", "millimetre of mercury", 133.322387415, 0, pressure, false},
    {"psi", "pound-force per square inch", 4.4482216152605 / (0.0254 * 0.0254), 0, pressure, false},
    {"P", "poise", 1, -1, viscosity, true},
    {"St", "stokes", 1, -4, diffusivity, true},
    {"dyn", "dyne", 1, -5, force, false},
    {"erg", "erg", 1, -7, energy, false},
    {"gn", "standard gravity", 980665, -5, acceleration, false},
    {"kgf", "kilogram-force", 980665, -5, force, false},
    {"lbf", "pound-force", 4.4482216152605, 0, force, false},
    {"eV", "electronvolt", 1602176634, -28, energy, true},
    {"Wh", "watt hour", 3600, 0, energy, true},
    {"Å", "angstrom", 1, -10, length, false},
    {"micron", "micron", 1, -6, length, false},
    {"in", "inch", 254, -4, length, false},
    {"ft", "foot", 3048, -4, length, false},
    {"lb", "pound", 45359237, -8, mass, false},
    {"oz", "ounce", 28349523125, -12, mass, false},
    {"%", "percent", 1, -2, none, false},
    {"‰", "per mille", 1, -3, none, false},
    {"ppm", "part per million", 1, -6, none, false},
};

constexpr Prefix prefixes[] = {{"da", 1}, {"y", -24}, {"z", -21}, {"a", -18}, {"f", -15}, {"p", -12}, {"n", -9},
                               {"u", -6}, {"µ", -6},  {"μ", -6},  {"m", -3},  {"c", -2},  {"d", -1},  {"h", 2},
                               {"k", 3},  {"M", 6},   {"G", 9},   {"T", 12},  {"P", 15},  {"E", 18}};

}  // namespace

std::span<const UnitRow> unit_table() { return units; }

std::span<const Prefix> prefix_table() { return prefixes; }

}  // namespace scree
