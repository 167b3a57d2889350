// What the benchmarks compute from their measurements.
#pragma once

#include <array>
#include <vector>

namespace scree {

/// The middle value; the upper of the two middle ones if there are evenly many. `values` must not be empty.
double median(std::vector<double> values);

/// The exponent p of the power law y = c x^p that fits positive points best: the slope of the least-squares line of
/// log y over log x. NaN with fewer than two different x.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

/// Bytes that one particle-step has to move to and from memory, with this many candidate pairs and acting contacts per
/// particle: what a particle's motion, spin and losses hold, both ways; for each candidate its entries in the lists;
/// for each acting contact its spring, both ways.
double bytes_per_particle_step(double candidates, double contacts);

/// How many times to repeat a cube along x, y, z for `copies` copies of it, as near to a cube as whole factors allow.
std::array<int, 3> repeats(int copies);

}  // namespace scree
