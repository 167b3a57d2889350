// Random numbers without state: every draw is a function of (seed, stream, count, draw) alone, so it is the same on
// any thread, rank and machine. Generator: Philox4x32-10 (Salmon, Moraes, Dror and Shaw 2011), from Random123.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace scree {

/// Names one block of random bits. `stream` keeps the uses apart, `count` is the number of the thing that the draw is
/// for (a particle of a group, say), `draw` numbers the draws for that thing.
struct RandomKey {
  std::uint64_t seed = 0;
  std::uint32_t stream = 0;
  std::uint64_t count = 0;
  std::uint32_t draw = 0;
};

/// The four random words of a key. Key words of Philox: the seed, low half first; counter words: count (low, high),
/// draw, stream.
inline std::array<std::uint32_t, 4> random_words(const RandomKey& key) {
  r123::Philox4x32 philox;
  const r123::Philox4x32::ctr_type counter{
      {static_cast<std::uint32_t>(key.count), static_cast<std::uint32_t>(key.count >> 32), key.draw, key.stream}};
  const r123::Philox4x32::key_type secret{
      {static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32)}};
  const auto words = philox(counter, secret);
  return {words[0], words[1], words[2], words[3]};
}

/// Two independent numbers, uniform on [0, 1): multiples of 2^-53.
inline std::array<double, 2> uniform_pair(const RandomKey& key) {
  const auto w = random_words(key);
  const auto unit = [](std::uint32_t high, std::uint32_t low) {
    return static_cast<double>(((std::uint64_t{high} << 32) | low) >> 11) * 0x1p-53;
  };
  return {unit(w[0], w[1]), unit(w[2], w[3])};
}

/// Two independent numbers, uniform on (0, 1): odd multiples of 2^-53, so neither 0 nor 1 occurs.
inline std::array<double, 2> uniform_open_pair(const RandomKey& key) {
  const auto w = random_words(key);
  const auto unit = [](std::uint32_t high, std::uint32_t low) {
    return (static_cast<double>(((std::uint64_t{high} << 32) | low) >> 12) + 0.5) * 0x1p-52;
  };
  return {unit(w[0], w[1]), unit(w[2], w[3])};
}

/// Uniform on [0, 1).
inline double uniform(const RandomKey& key) { return uniform_pair(key)[0]; }

/// Uniform on (0, 1).
inline double uniform_open(const RandomKey& key) { return uniform_open_pair(key)[0]; }

}  // namespace scree
