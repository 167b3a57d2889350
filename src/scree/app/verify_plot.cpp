#include "scree/app/verify_plot.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "scree/app/verify_names.h"

namespace scree {
namespace {

nlohmann::json numbers(const std::vector<double>& values) {
  nlohmann::json list = nlohmann::json::array();
  for (const double value : values) list.push_back(std::isfinite(value) ? nlohmann::json(value) : nullptr);
  return list;
}

nlohmann::json curve(const std::string& label, const std::vector<double>& x, const std::vector<double>& y,
                     const std::vector<double>& reference) {
  return {{"label", label}, {"x", numbers(x)}, {"y", numbers(y)}, {"reference", numbers(reference)}};
}

// Rows of each run against each other, one curve per variant.
nlohmann::json curves_over_rows(const VerifyPlotKeys& plot, const std::vector<std::size_t>& places,
                                const std::vector<VariantRun>& runs,
                                const std::vector<std::unique_ptr<Formulas>>& formulas) {
  nlohmann::json curves = nlohmann::json::array();
  for (const std::size_t i : places) {
    if (!formulas[i]) continue;
    const std::vector<double> reference =
        plot.reference.empty() ? std::vector<double>{} : formulas[i]->rows(plot.reference);
    curves.push_back(curve(runs[i].keys.name, formulas[i]->rows(plot.x), formulas[i]->rows(plot.y), reference));
  }
  return curves;
}

// One point per variant, one curve in all.
nlohmann::json curve_over_variants(const VerifyPlotKeys& plot, const std::vector<std::size_t>& places,
                                   const std::vector<std::unique_ptr<Formulas>>& formulas) {
  std::vector<double> x, y, reference;
  for (const std::size_t i : places) {
    if (!formulas[i]) continue;
    x.push_back(formulas[i]->value(plot.x));
    y.push_back(formulas[i]->value(plot.y));
    if (!plot.reference.empty()) reference.push_back(formulas[i]->value(plot.reference));
  }
  return nlohmann::json::array({curve("", x, y, reference)});
}

}  // namespace

std::string plot_json(const std::string& title, const VerifyKeys& keys, const std::vector<VariantRun>& runs) {
  const std::vector<std::unique_ptr<Formulas>> formulas = prepare_formulas(keys, runs);
  nlohmann::json plots = nlohmann::json::array();
  for (const VerifyPlotKeys& plot : keys.plots) {
    const std::vector<std::size_t> places = select_runs(plot.variants, runs);
    plots.push_back({{"title", plot.title},
                     {"x_label", plot.x_label},
                     {"y_label", plot.y_label},
                     {"logarithmic", plot.logarithmic},
                     {"points", plot.per_variant},
                     {"curves", plot.per_variant ? curve_over_variants(plot, places, formulas)
                                                 : curves_over_rows(plot, places, runs, formulas)}});
  }
  return nlohmann::json{{"title", title}, {"source", keys.source}, {"plots", plots}}.dump(1) + "\n";
}

}  // namespace scree
