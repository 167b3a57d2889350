// Sums of doubles without any rounding on the way: the result depends on the values alone, not on their order or
// grouping.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace scree {

/// A sum of doubles held exactly, as a fixed-point number wide enough for every finite double.
///
/// Threads and ranks may sum any shares and merge them with add(): every order and partition gives the same bits. A sum
/// is a plain value of about half a kilobyte and may be copied bytewise. (After the small superaccumulator of Neal
/// 2015, "Fast exact summation using small and large superaccumulators", arXiv:1505.05571.)
class ExactSum {
 public:
  /// Adds a value. Infinities and NaN spoil the sum as they would spoil a plain one.
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const auto exponent = static_cast<unsigned>(bits >> 52) & 0x7ffu;
    if (exponent == 0x7ffu) {
      special_ += value;
      return;
    }
    if (pending_ == most_pending) carry();
    ++pending_;
    // A subnormal has the exponent of the smallest normal number and no hidden bit.
    const std::uint64_t hidden = exponent != 0 ? std::uint64_t{1} << 52 : 0;
    const std::uint64_t mantissa = (bits & ((std::uint64_t{1} << 52) - 1)) | hidden;
    const unsigned place = exponent | (exponent == 0);
    const unsigned shift = place & 31u;
    const auto low = static_cast<std::int64_t>((mantissa << shift) & digit_mask);
    const auto high = static_cast<std::int64_t>(mantissa >> (32 - shift));
    const std::int64_t sign = static_cast<std::int64_t>(bits) >> 63;  // 0 or -1: negates without a branch
    std::int64_t* digit = digits_.data() + (place >> 5);
    digit[0] += (low ^ sign) - sign;
    digit[1] += (high ^ sign) - sign;
  }

  /// Adds everything that another sum holds.
  void add(const ExactSum& other) {
    ExactSum theirs = other;
    theirs.carry();
    carry();
    for (int i = 0; i < count; ++i) digits_[i] += theirs.digits_[i];
    carry();
    special_ += theirs.special_;
  }

  /// The sum rounded once, to the nearest double (ties to even); infinity beyond the largest, +0 for an exact zero.
  double value() const {
    if (special_ != special_) return std::numeric_limits<double>::quiet_NaN();
    if (special_ != 0) return special_;
    ExactSum sum = *this;
    sum.carry();
    const bool negative = sum.digits_[count - 1] < 0;
    if (negative) sum.negate();
    const double magnitude = sum.rounded();
    return negative ? -magnitude : magnitude;
  }

 private:
  // Digit i counts in units of 2^(32 i - 1075). After carry() all lie in [0, 2^32) but the last, which has the sign.
  // The largest double reaches into digit 64; the two above hold the carries of up to 2^63 such values.
  static constexpr int count = 67;
  static constexpr std::uint64_t digit_mask = 0xffffffffu;
  // One value changes a digit by less than 2^52 + 2^32, so that a thousand of them stay within 63 bits.
  static constexpr std::int64_t most_pending = 1000;

  void carry() {
    std::int64_t above = 0;
    for (int i = 0; i + 1 < count; ++i) {
      const std::int64_t sum = digits_[i] + above;
      digits_[i] = sum & static_cast<std::int64_t>(digit_mask);
      above = sum >> 32;
    }
    digits_[count - 1] += above;
    pending_ = 0;
  }

  void negate() {
    for (auto& digit : digits_) digit = -digit;
    carry();
  }

  /// Bit `position` and the 62 below it, of a carried sum that is not negative.
  std::uint64_t bits_below(int position) const {
    std::uint64_t bits = 0;
    for (int i = 0; i < 63; ++i) {
      const int place = position - i;
      const std::uint64_t bit = place < 0 ? 0 : static_cast<std::uint64_t>(digits_[place / 32]) >> (place % 32) & 1u;
      bits = bits << 1 | bit;
    }
    return bits;
  }

  bool any_below(int position) const {
    for (int place = 0; place < position;) {
      const bool whole = place % 32 == 0 && place + 32 <= position;
      const auto digit = static_cast<std::uint64_t>(digits_[place / 32]);
      if (whole ? digit != 0 : (digit >> (place % 32) & 1u) != 0) return true;
      place += whole ? 32 : 1;
    }
    return false;
  }

  double rounded() const {
    int top = count - 1;
    while (top >= 0 && digits_[top] == 0) --top;
    if (top < 0) return 0.0;
    const int leading = 32 * top + 63 - std::countl_zero(static_cast<std::uint64_t>(digits_[top]));
    if (leading > 2046 + 52) return std::numeric_limits<double>::infinity();
    // The mantissa has 53 bits, fewer where the last of them would lie below the smallest subnormal (bit 1).
    const int last = leading - 52 > 1 ? leading - 52 : 1;
    const int kept = leading - last + 1;
    const std::uint64_t bits = bits_below(leading);
    std::uint64_t mantissa = bits >> (63 - kept);
    const bool half = bits >> (62 - kept) & 1u;
    if (half && ((mantissa & 1u) != 0 || any_below(last - 1))) ++mantissa;
    return scaled(mantissa, last);
  }

  /// mantissa * 2^(last - 1075), which is a double or too large for one.
  static double scaled(std::uint64_t mantissa, int last) {
    if (mantissa >> 53) {
      mantissa >>= 1;
      ++last;
    }
    if (last > 2046) return std::numeric_limits<double>::infinity();
    const bool normal = (mantissa >> 52) != 0;
    const std::uint64_t exponent = normal ? static_cast<std::uint64_t>(last) : 0;
    return std::bit_cast<double>(exponent << 52 | (mantissa & ((std::uint64_t{1} << 52) - 1)));
  }

  std::array<std::int64_t, count> digits_{};
  double special_ = 0;  // sum of the infinities and NaN
  // Values added since the last carry. As wide as the rest: sums are saved as they lie in memory, where a gap would
  // hold whatever was there before.
  std::int64_t pending_ = 0;
};
static_assert(sizeof(ExactSum) == (67 + 2) * sizeof(std::int64_t));

/// The sum of vectors, component by component.
struct ExactVectorSum {
  ExactSum x, y, z;

  void add(double dx, double dy, double dz) {
    x.add(dx);
    y.add(dy);
    z.add(dz);
  }
  void add(const ExactVectorSum& other) {
    x.add(other.x);
    y.add(other.y);
    z.add(other.z);
  }
  std::array<double, 3> value() const { return {x.value(), y.value(), z.value()}; }
};

}  // namespace scree
