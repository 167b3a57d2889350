// Time per value of the functions of physics/math.h beside those of the library, and of the exact sum.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "scree/base/exact_sum.h"
#include "scree/physics/math.h"

namespace {

constexpr std::size_t count = 1024;

std::vector<double> values_between(double low, double high) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(low, high);
  std::vector<double> values(count);
  for (double& v : values) v = uniform(random);
  return values;
}

/// Reports the processor's time per value.
void count_values(benchmark::State& state) {
  state.counters["per_item"] = benchmark::Counter(
      static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// A loop over values in cache, as kernels have them: it vectorises where the function allows it.
template <class Function>
void each(benchmark::State& state, Function function, double low, double high) {
  const std::vector<double> x = values_between(low, high);
  std::vector<double> y(count);
  for (auto _ : state) {
    for (std::size_t i = 0; i < count; ++i) y[i] = function(x[i]);
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  count_values(state);
}

void exact_sum(benchmark::State& state) {
  const std::vector<double> x = values_between(-1, 1);
  for (auto _ : state) {
    scree::ExactSum sum;
    for (const double v : x) sum.add(v);
    benchmark::DoNotOptimize(sum.value());
  }
  count_values(state);
}

void plain_sum(benchmark::State& state) {
  const std::vector<double> x = values_between(-1, 1);
  for (auto _ : state) {
    double sum = 0;
    for (const double v : x) sum += v;
    benchmark::DoNotOptimize(sum);
  }
  count_values(state);
}

#define EACH(name, function, low, high) \
  BENCHMARK_CAPTURE(                    \
      each, name, [](double x) { return function; }, low, high)

EACH(exp, sc_exp(x), -20, 20);
EACH(exp_libm, std::exp(x), -20, 20);
EACH(log, sc_log(x), 1e-3, 1e3);
EACH(log_libm, std::log(x), 1e-3, 1e3);
EACH(sin, sc_sin(x), -10, 10);
EACH(sin_libm, std::sin(x), -10, 10);
EACH(cos, sc_cos(x), -10, 10);
EACH(cos_libm, std::cos(x), -10, 10);
EACH(pow, sc_pow(x, 0.687), 1e-3, 1e3);
EACH(pow_libm, std::pow(x, 0.687), 1e-3, 1e3);
EACH(cbrt, sc_cbrt(x), 1e-3, 1e3);
EACH(cbrt_libm, std::cbrt(x), 1e-3, 1e3);
BENCHMARK(exact_sum);
BENCHMARK(plain_sum);

}  // namespace
