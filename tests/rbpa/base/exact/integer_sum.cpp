#include "rbpa/base/exact/integer_sum.h"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "oracle/rational.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::ExactSum;
using rbpa::IntegerSum;

TEST_SUITE_BEGIN("arrays");

TEST_CASE("sums of products of integers at the limits of their range equal those of integers of any length") {
  Random random(601);
  for (int trial = 0; trial < 300; ++trial) {
    IntegerSum sum;
    boost::multiprecision::cpp_int expected = 0;
    const auto number = [&](unsigned bits) {  // of a size anywhere below 2^bits, or next to it
      const std::uint64_t any = random.below(std::uint64_t{1} << 61u) >> random.below(62);
      auto value =
          static_cast<std::int64_t>(random.chance(0.2) ? (std::uint64_t{1} << bits) - 1 - random.below(2) : any);
      return random.chance(0.5) ? -value : value;
    };
    const int terms = 1 + static_cast<int>(random.below(200));
    for (int i = 0; i < terms; ++i) {
      const std::int64_t high = number(61), low = number(61), b = number(62);
      const rbpa::Integer128 a = rbpa::Integer128{high} * (std::int64_t{1} << 62) + low;
      sum.add_product(a, b);
      expected += (boost::multiprecision::cpp_int(high) * (std::int64_t{1} << 62) + low) * b;
    }
    ExactSum exact;
    const int exponent = static_cast<int>(random.below(3000)) - 1500;
    sum.add_to(exact, exponent);
    // Subtracts all but the last bits: the rest has no error.
    boost::multiprecision::cpp_int rest = abs(expected);
    const int sign = expected < 0 ? 1 : -1;
    for (int shift = 0; rest != 0; rest >>= 32, shift += 32) {
      const auto digit = static_cast<double>(static_cast<std::uint32_t>(rest & 0xffffffffu));
      const int at = exponent + shift;
      exact.add_product(sign * std::ldexp(digit, at / 2), std::ldexp(1.0, at - at / 2));
    }
    CHECK(exact.digits() == ExactSum().digits());
  }
}

TEST_SUITE_END();
