#include "rbpa/base/exact/exact_sum.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rbpa {
namespace {

// Position of the bit of weight 1. The last bit of a product has a weight of 2^−2148 or more, and thus position 188 or
// higher. The digits below are for rounded(), which reads two digits after the first.
constexpr int offset = 2336;
constexpr std::int64_t digit_mask = 0xFFFFFFFF;

struct Scaled {
  std::uint64_t significand;  // below 2^53
  int exponent;
  bool negative;
};

Scaled scaled(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto field = static_cast<int>((bits >> 52U) & 0x7FFU);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52U) - 1);
  // The implicit bit of the significand, which subnormal numbers do not have.
  const std::uint64_t first = field == 0 ? 0 : std::uint64_t{1} << 52U;
  return {first | fraction, std::max(field, 1) - 1075, (bits >> 63U) != 0};
}

}  // namespace

void ExactSum::add_bits(std::uint64_t bits, unsigned position, bool negative) {
  const std::size_t digit = position / 32;
  const unsigned shift = position % 32;
  const std::uint64_t low = bits << shift, high = shift == 0 ? 0 : bits >> (64 - shift);
  const std::int64_t parts[] = {static_cast<std::int64_t>(low) & digit_mask, static_cast<std::int64_t>(low >> 32U),
                                static_cast<std::int64_t>(high)};
  for (std::size_t i = 0; i < 3; ++i) digits_[digit + i] += negative ? -parts[i] : parts[i];
}

/// Extends [begin_, end_) to the digits that change when bits are added at `first_position` to `last_position`.
void ExactSum::touch(unsigned first_position, unsigned last_position) {
  begin_ = std::min<std::size_t>(begin_, first_position / 32);
  end_ = std::max<std::size_t>(end_, last_position / 32 + 3);
}

void ExactSum::add(double value) {
  const Scaled x = scaled(value);
  const auto position = static_cast<unsigned>(x.exponent + offset);
  touch(position, position);
  add_bits(x.significand, position, x.negative);
  added();
}

void ExactSum::add_product(double a, double b) {
  const Scaled x = scaled(a), y = scaled(b);
  const bool negative = x.negative != y.negative;
  const auto position = static_cast<unsigned>(x.exponent + y.exponent + offset);
  constexpr std::uint64_t low_mask = (1U << 27U) - 1;
  touch(position, position + 54);
  const std::uint64_t x1 = x.significand >> 27U, x0 = x.significand & low_mask;
  const std::uint64_t y1 = y.significand >> 27U, y0 = y.significand & low_mask;
  add_bits(x0 * y0, position, negative);
  add_bits(x0 * y1 + x1 * y0, position + 27, negative);
  add_bits(x1 * y1, position + 54, negative);
  added();
}

void ExactSum::added() {
  // A product adds less than 2^34 to a digit, and a digit can hold almost 2^63: carries can wait for 2^28 products.
  if (++additions_ < (1U << 28U)) return;
  carry(digits_);
  additions_ = 0;
  begin_ = 0;
  end_ = digits_.size();
}

void ExactSum::carry(Digits& digits) {
  std::int64_t carried = 0;
  for (std::size_t i = 0; i + 1 < digits.size(); ++i) {
    const std::int64_t digit = digits[i] + carried;
    digits[i] = digit & digit_mask;
    carried = digit >> 32;  // rounds down
  }
  digits.back() += carried;  // the last digit keeps the sign
}

ExactSum& ExactSum::operator+=(const ExactSum& other) {
  const Digits added = other.digits();
  carry(digits_);
  for (std::size_t i = 0; i < added.size(); ++i) digits_[i] += added[i];
  additions_ = 1;  // two digits after carries add up to less than one product adds
  begin_ = 0;
  end_ = digits_.size();
  return *this;
}

ExactSum::Digits ExactSum::digits() const {
  Digits digits = digits_;
  carry(digits);
  return digits;
}

ExactSum ExactSum::of(const Digits& digits) {
  ExactSum sum;
  sum.digits_ = digits;
  sum.additions_ = 1;
  sum.begin_ = 0;
  sum.end_ = digits.size();
  return sum;
}

double ExactSum::rounded(int exponent) const {
  if (begin_ >= end_) return 0;
  // The digits of the absolute value, without leading zeros.
  Digits size;
  // Fills `size` from digits and returns the carry out of the last of them. The type has more digits than any sum
  // needs, so no carry leaves `size`.
  const auto carried_from = [&](const Digits& digits, bool negative) {
    std::int64_t carried = 0;
    for (std::size_t i = begin_; i < end_; ++i) {
      const std::int64_t digit = (negative ? -digits[i] : digits[i]) + carried;
      size[i] = digit & digit_mask;
      carried = digit >> 32;  // rounds down
    }
    return carried;
  };
  std::int64_t carried = carried_from(digits_, false);
  const bool negative = carried < 0;
  if (negative) carried = carried_from(digits_, true);
  std::size_t top = end_;
  if (carried != 0)
    size[top] = carried;
  else
    do {
      if (top == begin_) return 0;
      --top;
    } while (size[top] == 0);
  const auto at = [&](std::size_t below) {
    return top < begin_ + below ? std::uint64_t{0} : static_cast<std::uint64_t>(size[top - below]);
  };

  // The first 64 bits. The last of the 64 is set if any lower bit is set, so that the conversion rounds correctly.
  const auto width = static_cast<unsigned>(std::bit_width(at(0)));
  std::uint64_t bits = (((at(0) << 32U) | at(1)) << (32 - width)) | (at(2) >> width);
  const bool more = (at(2) & ((std::uint64_t{1} << width) - 1)) != 0 ||
                    (top > begin_ + 2 && std::any_of(size.begin() + static_cast<std::ptrdiff_t>(begin_),
                                                     size.begin() + static_cast<std::ptrdiff_t>(top - 2),
                                                     [](std::int64_t digit) { return digit != 0; }));
  bits |= more ? 1U : 0U;
  const int position = 32 * (static_cast<int>(top) - 1) - (32 - static_cast<int>(width)) - offset;
  const double rounded = std::ldexp(static_cast<double>(bits), position + exponent);
  return negative ? -rounded : rounded;
}

}  // namespace rbpa
