// What `scree verify` runs and expects.
#include "scree/input/keys.h"

namespace scree {
namespace {

const Section& variants_section() {
  using S = VariantKeys;
  static const Section section = {
      "verify.variants",
      "[[verify.variants]]",
      "A run of a verification case with some keys changed.",
      {key("name", &S::name, "name of the variant").is_a(TextKind::name).required(),
       key("set", &S::set, "changed keys, each \"key.path=value\" as on the command line"),
       key("parameter", &S::parameter, "what the variants vary, for orders of convergence (the time step, say)"),
       key("wrong", &S::wrong, "a term is deliberately wrong: at least one expectation must fail"),
       key("define", &S::define, "\"name = formula\": names of this variant, before those of the case")},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& plots_section() {
  using S = VerifyPlotKeys;
  static const Section section = {
      "verify.plots",
      "[[verify.plots]]",
      "A picture of a verification case over its reference, drawn by `scree verify --plot`.",
      {key("title", &S::title, "headline"), key("x", &S::x, "formula of the abscissa").is_a(TextKind::formula),
       key("y", &S::y, "formula of the ordinate").is_a(TextKind::formula).required(),
       key("reference", &S::reference, "formula of what the ordinate must be")
           .is_a(TextKind::formula)
           .defaults_to("none"),
       key("x_label", &S::x_label, "words at the abscissa"), key("y_label", &S::y_label, "words at the ordinate"),
       key("variants", &S::variants, "names of the variants drawn").defaults_to("every variant that is not wrong"),
       key("per_variant", &S::per_variant, "one point for each variant instead of one curve for each"),
       key("logarithmic", &S::logarithmic, "both axes are logarithmic")},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace

const Section& verify_section() {
  using S = VerifyKeys;
  static const Section section = {
      "verify",
      "[verify]",
      "A verification case: what it shows, and where its truth comes from.",
      {key("title", &S::title, "what is verified, in words"),
       key("source", &S::source, "where the expected values come from: author, year, equation"),
       key("define", &S::define, "\"name = formula\": names that the formulas may use, in order"),
       tables<S, VariantKeys>(
           "variants", [](S & s) -> auto& { return s.variants; }, variants_section()),
       tables<S, VerifyPlotKeys>(
           "plots", [](S & s) -> auto& { return s.plots; }, plots_section())},
      [] { return std::make_shared<S>(); }};
  return section;
}

const Section& expect_section() {
  using S = ExpectKeys;
  static const Section section = {
      "expect",
      "[[expect]]",
      "One number that a verification case must reproduce.",
      {key("what", &S::what, "the number in words").required(),
       key("value", &S::value, "formula of the results").is_a(TextKind::formula).required(),
       key("equals", &S::equals, "what it must be: a number or a formula").is_a(TextKind::formula).defaults_to("none"),
       key("tolerance", &S::tolerance, "largest difference from `equals`").at_least(0),
       key("relative", &S::relative, "largest difference as a fraction of `equals`").at_least(0),
       key("at_least", &S::at_least, "lower bound").defaults_to("none"),
       key("at_most", &S::at_most, "upper bound").defaults_to("none"),
       key("variants", &S::variants, "names of the variants it holds for")
           .defaults_to("every variant that is not wrong"),
       key("source", &S::source, "author, year, equation").defaults_to("that of the case")},
      [] { return std::make_shared<S>(); }};
  return section;
}

}  // namespace scree
