// The fractal dimension of a population of agglomerates.
#pragma once

#include <cstdint>
#include <span>

#include "scree/analysis/agglomerates.h"

namespace scree {

/// Agglomerates with fewer particles say more about the particles than about how they are put together.
inline constexpr std::int64_t smallest_fractal = 10;

/// N = prefactor * (Rg / a)^dimension, a: mean radius of the primary particles of the agglomerate.
struct FractalFit {
  double dimension = 0;           // NaN if there is too little to fit
  double dimension_error = 0;     // standard error of the dimension; NaN as the dimension
  double prefactor = 0;           // NaN as the dimension
  std::int64_t agglomerates = 0;  // how many were fitted
};

/// Fits a straight line to log N over log(Rg / a) by least squares, over all agglomerates of at least
/// `smallest_fractal` particles that do not span the box. It needs three of different sizes, else the fit is NaN.
/// The standard error is that of a slope with N - 2 degrees of freedom. (Forrest and Witten 1979 for the power law.)
FractalFit fit_fractal_dimension(std::span<const Agglomerate> agglomerates);

}  // namespace scree
