// Eight contacts side by side: rows of four numbers turned into columns of eight and back.
//
// GCC's vector types, so that one text serves every instruction set; the compiler splits them where registers are
// short.
#pragma once

#include <cstdint>
#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace scree {
namespace {

using lane4 = double __attribute__((vector_size(32)));
using lane8 = double __attribute__((vector_size(64)));
using mask4 = std::int64_t __attribute__((vector_size(32)));
using mask8 = std::int64_t __attribute__((vector_size(64)));

[[gnu::always_inline]] inline lane4 load4(const double* p) {
  lane4 v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
[[gnu::always_inline]] inline void store4(double* p, lane4 v) { __builtin_memcpy(p, &v, sizeof v); }
[[gnu::always_inline]] inline lane8 load8(const double* p) {
  lane8 v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
[[gnu::always_inline]] inline void store8(double* p, lane8 v) { __builtin_memcpy(p, &v, sizeof v); }

/// Lanes 0 to 2 of `a`, lane 3 of `b`.
[[gnu::always_inline]] inline lane4 last_of(lane4 a, lane4 b) { return __builtin_shufflevector(a, b, 0, 1, 2, 7); }

[[gnu::always_inline]] inline lane8 join(lane4 a, lane4 b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

// The steps of a transposition: even or odd lanes of both in turn; first or second halves of each four.
[[gnu::always_inline]] inline lane8 even(lane8 a, lane8 b) {
  return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
[[gnu::always_inline]] inline lane8 odd(lane8 a, lane8 b) {
  return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}
[[gnu::always_inline]] inline lane8 front(lane8 a, lane8 b) {
  return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
}
[[gnu::always_inline]] inline lane8 back(lane8 a, lane8 b) {
  return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// Four columns of eight; the same network transposes in both directions.
struct Columns {
  lane8 x, y, z, w;
};

[[gnu::always_inline]] inline Columns columns_of(const lane4 (&row)[8]) {
  const lane8 a = join(row[0], row[4]), b = join(row[1], row[5]), c = join(row[2], row[6]), d = join(row[3], row[7]);
  const lane8 ab0 = even(a, b), ab1 = odd(a, b), cd0 = even(c, d), cd1 = odd(c, d);
  return {front(ab0, cd0), front(ab1, cd1), back(ab0, cd0), back(ab1, cd1)};
}

[[gnu::always_inline]] inline void rows_of(const Columns& c, lane4 (&row)[8]) {
  const lane8 xy0 = even(c.x, c.y), xy1 = odd(c.x, c.y), zw0 = even(c.z, c.w), zw1 = odd(c.z, c.w);
  const auto put = [&row](int a, int b, lane8 v) {
    row[a] = __builtin_shufflevector(v, v, 0, 1, 2, 3);
    row[b] = __builtin_shufflevector(v, v, 4, 5, 6, 7);
  };
  put(0, 4, front(xy0, zw0));
  put(1, 5, front(xy1, zw1));
  put(2, 6, back(xy0, zw0));
  put(3, 7, back(xy1, zw1));
}

/// One bit per lane of a comparison's result.
[[gnu::always_inline]] inline unsigned bits_of(mask8 m) {
#ifdef __AVX512DQ__
  return _mm512_movepi64_mask((__m512i)m);
#else
  unsigned bits = 0;
  for (int l = 0; l < 8; ++l) bits |= static_cast<unsigned>(m[l] & 1) << l;
  return bits;
#endif
}

/// One bit for each of eight numbers that is not negative. Loops over eight numbers that end in such signs vectorise as
/// wide as registers are; comparisons of eight lanes are taken apart into single ones where registers hold four.
[[gnu::always_inline]] inline unsigned not_negative(const double* p) {
#ifdef __AVX512DQ__
  return 0xffu & ~static_cast<unsigned>(_mm512_movepi64_mask(_mm512_loadu_si512(p)));
#elif defined(__AVX__)
  const int low = _mm256_movemask_pd(_mm256_loadu_pd(p)), high = _mm256_movemask_pd(_mm256_loadu_pd(p + 4));
  return 0xffu & ~static_cast<unsigned>(low | high << 4);
#elif defined(__SSE2__)
  unsigned negative = 0;
  for (int l = 0; l < 8; l += 2) negative |= static_cast<unsigned>(_mm_movemask_pd(_mm_loadu_pd(p + l))) << l;
  return 0xffu & ~negative;
#else
  unsigned bits = 0;
  for (int l = 0; l < 8; ++l) bits |= static_cast<unsigned>(!__builtin_signbit(p[l])) << l;
  return bits;
#endif
}

/// Bit 0 of each of eight bytes.
[[gnu::always_inline]] inline unsigned bits_of(const std::uint8_t* bytes) {
  std::uint64_t all;
  __builtin_memcpy(&all, bytes, sizeof all);
  return static_cast<unsigned>(((all & 0x0101010101010101u) * 0x0102040810204080u) >> 56);
}

/// Writes the lanes that `bits` names to `to`, close together; the rest of eight places is overwritten with anything.
[[gnu::always_inline]] inline void pack(double* to, lane8 v, unsigned bits) {
#ifdef __AVX512DQ__
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(bits), (__m512d)v));
#else
  for (int l = 0; l < 8; ++l) {
    *to = v[l];
    to += bits >> l & 1;
  }
#endif
}

/// The same for the numbers from `first` on.
[[gnu::always_inline]] inline void pack_numbers(std::int32_t* to, std::int32_t first, unsigned bits) {
#ifdef __AVX512DQ__
  const __m256i numbers = _mm256_add_epi32(_mm256_set1_epi32(first), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                      _mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), numbers));
#else
  for (int l = 0; l < 8; ++l) {
    *to = first + l;
    to += bits >> l & 1;
  }
#endif
}

}  // namespace
}  // namespace scree
