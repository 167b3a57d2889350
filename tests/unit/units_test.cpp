// Quantities against UDUNITS 2.2.28 (converted with its library, 15 digits), and the parser's refusals.
#include "scree/base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "scree/base/edit_distance.h"
#include "scree/base/error.h"

namespace scree {
namespace {

struct Conversion {
  const char* text;
  const char* si_unit;
  double value;
};

class AgainstUdunits : public testing::TestWithParam<Conversion> {};

TEST_P(AgainstUdunits, ValueAndDimension) {
  const Conversion& c = GetParam();
  const QuantityResult result = parse_quantity(c.text);
  ASSERT_FALSE(result.problem) << result.problem->message;
  EXPECT_NEAR(result.quantity.value, c.value, 5e-15 * std::abs(c.value)) << c.text;
  EXPECT_EQ(to_string(result.quantity.dimension), to_string(dimension_of(c.si_unit))) << c.text;
}

INSTANTIATE_TEST_SUITE_P(
    Units, AgainstUdunits,
    testing::Values(
        Conversion{"1.2 g/cm3", "kg/m3", 1200}, Conversion{"300 rpm", "rad/s", 31.4159265358979},
        Conversion{"90 deg", "rad", 1.5707963267949}, Conversion{"1 mPa s", "Pa s", 0.001},
        Conversion{"70 GPa", "Pa", 7e10}, Conversion{"25 um", "m", 2.5e-05}, Conversion{"25 µm", "m", 2.5e-05},
        Conversion{"2.5 h", "s", 9000}, Conversion{"3 min", "s", 180}, Conversion{"5 %", "", 0.05},
        Conversion{"50 mJ/m2", "J/m2", 0.05}, Conversion{"981 cm/s2", "m/s2", 9.81}, Conversion{"3 N s/m", "kg/s", 3},
        Conversion{"1 atm", "Pa", 101325}, Conversion{"760 mmHg", "Pa", 101325.0144354},
        Conversion{"14.5 psi", "Pa", 99973.9807509412}, Conversion{"2 cSt", "m2/s", 2e-06},
        Conversion{"1 Wh", "J", 3600}, Conversion{"1 kgf", "N", 9.80665}, Conversion{"1 lbf", "N", 4.4482216152605},
        Conversion{"7 lb", "kg", 3.17514659}, Conversion{"12 in", "m", 0.3048}, Conversion{"3 ft", "m", 0.9144},
        Conversion{"2 L/min", "m3/s", 3.33333333333333e-05}, Conversion{"7 bar", "Pa", 7e5},
        Conversion{"1013 mbar", "Pa", 101300}, Conversion{"4 t/h", "kg/s", 1.11111111111111},
        Conversion{"10 erg", "J", 1e-06}, Conversion{"5 ppm", "", 5e-06}, Conversion{"1 d", "s", 86400},
        Conversion{"12 W/(m K)", "kg m s-3 K-1", 12}, Conversion{"3 kPa/mm2", "Pa/m2", 3e9},
        Conversion{"1 rev", "rad", 6.28318530717959}, Conversion{"2 kHz", "1/s", 2000},
        Conversion{"9 N/mm", "N/m", 9000}, Conversion{"5 mmol/l", "mol/m3", 5}, Conversion{"3 kg m-3", "kg/m3", 3},
        Conversion{"1 micron", "m", 1e-06}, Conversion{"3 kV", "kg m2 s-3 A-1", 3000}, Conversion{"4 nN", "N", 4e-09},
        Conversion{"6 ug", "kg", 6e-09}, Conversion{"1 dyn", "N", 1e-05}, Conversion{"8 m^2 s^-1", "m2/s", 8},
        Conversion{"5 1/ms", "s-1", 5000}, Conversion{"1 gn", "m/s2", 9.80665}, Conversion{"2 Å", "m", 2e-10},
        Conversion{"3 km/h", "m/s", 0.833333333333333}, Conversion{"1 MJ/(kg K)", "m2 s-2 K-1", 1e6}));

TEST(Units, ValuesThatUdunitsHasOtherwise) {
  EXPECT_DOUBLE_EQ(parse_quantity("2 P").quantity.value, 0.2);               // poise: unknown to it
  EXPECT_DOUBLE_EQ(parse_quantity("1 eV").quantity.value, 1.602176634e-19);  // CODATA 2018; it has that of 1986
  EXPECT_DOUBLE_EQ(parse_quantity("16 oz").quantity.value, 0.45359237);      // a pound; its ounce is rounded
  EXPECT_DOUBLE_EQ(parse_quantity("1 °").quantity.value, std::acos(-1.0) / 180);
}

TEST(Units, DecimalFactorsAreRoundedOnce) {
  EXPECT_EQ(parse_quantity("1.2 mm").quantity.value, 0.0012);
  EXPECT_EQ(parse_quantity("0.3 um").quantity.value, 0.3e-6);
  EXPECT_EQ(parse_quantity("2.65 g/cm3").quantity.value, 2650.0);
  EXPECT_EQ(parse_quantity("1e-3 GPa").quantity.value, 1e6);
  EXPECT_EQ(parse_quantity("17.9 uPa s").quantity.value, 17.9e-6);
}

TEST(Units, WaysOfWriting) {
  for (const char* text : {"2.5 kg/m3", "2.5kg/m3", "+2.5 kg/m^3", " 2.5  kg / m**3 ", "2.5 kg·m⁻³", "2.5 kg*m^-3",
                           "25e-1 kg m-3", "2.5 kg/(m m2)", "2.5 kg/m/m/m", "2.5 (kg)/(m3)"}) {
    const QuantityResult result = parse_quantity(text);
    ASSERT_FALSE(result.problem) << text << ": " << result.problem->message;
    EXPECT_EQ(result.quantity.value, 2.5) << text;
    EXPECT_EQ(result.quantity.dimension, dimension_of("kg/m3")) << text;
    EXPECT_TRUE(result.has_unit);
  }
  EXPECT_FALSE(parse_quantity("2.5").has_unit);
}

TEST(Units, AnAngleIsADimension) {
  EXPECT_NE(dimension_of("Hz"), dimension_of("rad/s"));
  EXPECT_EQ(dimension_of("rpm"), dimension_of("deg/s"));
}

struct Refusal {
  const char* text;
  std::size_t offset, length;
  const char* message;
};

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithTheFaultyPart) {
  const Refusal& r = GetParam();
  const QuantityResult result = parse_quantity(r.text);
  ASSERT_TRUE(result.problem) << r.text;
  EXPECT_EQ(result.problem->message, r.message);
  EXPECT_EQ(result.problem->offset, r.offset) << r.text;
  EXPECT_EQ(result.problem->length, r.length) << r.text;
}

INSTANTIATE_TEST_SUITE_P(
    Units, Refused,
    testing::Values(Refusal{"5 mmm", 2, 3, "'mmm' is not a unit"}, Refusal{"5 m/ss", 4, 2, "'ss' is not a unit"},
                    Refusal{"m", 0, 1, "a quantity begins with a number"},
                    Refusal{"", 0, 0, "a quantity begins with a number"},
                    Refusal{"inf m", 0, 5, "a quantity begins with a number"},
                    Refusal{"+-3 m", 0, 5, "a quantity begins with a number"},
                    Refusal{"3 m/", 4, 0, "a unit is missing"}, Refusal{"3 (m", 2, 1, "the parenthesis is not closed"},
                    Refusal{"3 m)", 3, 1, "cannot read ')' in the unit"},
                    Refusal{"3 m^", 3, 1, "a unit's power must be a whole number from 1 to 9"},
                    Refusal{"3 m0", 3, 1, "a unit's power must be a whole number from 1 to 9"},
                    Refusal{"3 m12", 3, 2, "a unit's power must be a whole number from 1 to 9"},
                    Refusal{"3 J/m2 s", 7, 1, "a product after '/' can be read in two ways"},
                    Refusal{"3 kmin", 2, 4, "'kmin' is not a unit"}, Refusal{"3 5 m", 2, 3, "'5 m' is not a unit"}));

TEST(Units, SuggestionsAndExtremes) {
  EXPECT_EQ(parse_quantity("5 pa").problem->help, "did you mean 'Pa'?");
  EXPECT_EQ(parse_quantity("5 seconds").problem->help, "did you mean 's'?");
  EXPECT_EQ(parse_quantity("20 degC").problem->help, "give temperatures in K");
  EXPECT_EQ(parse_quantity("1e999 m").quantity.value, HUGE_VAL);
  EXPECT_EQ(parse_quantity("1e-999 m").quantity.value, 0.0);
  EXPECT_EQ(parse_quantity("1e99999999999999999999 m").quantity.value, HUGE_VAL);
  EXPECT_TRUE(parse_quantity(std::string(100000, '(')).problem);
  EXPECT_TRUE(parse_quantity("1 " + std::string(150, '(')).problem);
  EXPECT_THROW(dimension_of("furlong"), InputError);
}

TEST(Units, NoSymbolIsTwiceInTheTableOrHiddenByAPrefix) {
  std::set<std::string> seen;
  for (const UnitName& unit : known_units()) EXPECT_TRUE(seen.insert(unit.symbol).second) << unit.symbol;
  EXPECT_GE(seen.size(), 40u);
}

TEST(EditDistance, KnownDistances) {
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("restitutoin", "restitution"), 1u);  // one swap
  EXPECT_EQ(edit_distance("CA", "ABC"), 3u);                   // restricted form; the unrestricted one has 2
  EXPECT_EQ(nearest("dampnig", {"stiffness", "damping", "camping"}), "damping");
  EXPECT_EQ(nearest("HERTZ", {"linear", "hertz"}), "hertz");
  EXPECT_EQ(nearest("x", {"y", "z"}), "");
  EXPECT_EQ(nearest("completely", {"different"}), "");
}

}  // namespace
}  // namespace scree
