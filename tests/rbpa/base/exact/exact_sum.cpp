#include "rbpa/base/exact/exact_sum.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "oracle/rational.h"
#include "support/arguments.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::ExactSum;

TEST_SUITE_BEGIN("shape");

namespace {

using Products = std::vector<std::pair<double, double>>;

double sum_of(const Products& products, int exponent = 0) {
  ExactSum sum;
  for (const auto& [a, b] : products) sum.add_product(a, b);
  return sum.rounded(exponent);
}

/// Returns whether `rounded` is the double nearest to `exact`; of two, the even one.
bool is_nearest(double rounded, const Rational& exact) {
  const auto distance = [&](double to) { return Rational(abs(Rational(rational(to) - exact))); };
  const double above = std::nextafter(rounded, 1e308), below = std::nextafter(rounded, -1e308);
  const Rational error = distance(rounded);
  if (error > distance(above) || error > distance(below)) return false;
  int exponent = 0;
  const bool even = static_cast<std::int64_t>(std::ldexp(std::frexp(rounded, &exponent), 53)) % 2 == 0;
  return even || (error != distance(above) && error != distance(below));
}

Products random_products(Random& random, int exponents) {
  Products products;
  const auto value = [&] {
    const double unit = random.between(-1, 1);
    return std::ldexp(random.chance(0.3) ? std::round(unit * 8) : unit, random.integer(-exponents, exponents));
  };
  for (int n = random.integer(1, 12); n > 0; --n) {
    const double a = value();
    products.emplace_back(a, value());
    if (random.chance(0.4)) products.emplace_back(-products.back().first, products.back().second);  // cancels
  }
  return products;
}

}  // namespace

TEST_CASE("a sum of products is rounded once, to the nearest double") {
  Random random(1);
  for (const int exponents : {0, 3, 30, 60, 400}) {
    CAPTURE(exponents);
    for (int run = 0; run < trials(2000); ++run) {
      const Products products = random_products(random, exponents);
      Rational exact = 0;
      for (const auto& [a, b] : products) exact += rational(a) * rational(b);
      REQUIRE(is_nearest(sum_of(products), exact));
    }
  }
}

TEST_CASE("a value halfway between two doubles is rounded to even, and the least bit beyond halfway decides") {
  const double tiny = 0x1p-500;
  CHECK(sum_of({{1, 1}, {0x1p-53, 1}}) == 1);
  CHECK(sum_of({{1, 1}, {0x1p-53, 1}, {tiny, tiny}}) == 1 + 0x1p-52);
  CHECK(sum_of({{1, 1}, {0x1p-53, 1}, {-tiny, tiny}}) == 1);
  CHECK(sum_of({{1, 1}, {0x1p-52, 1}, {0x1p-53, 1}}) == 1 + 0x1p-51);
}

TEST_CASE("huge terms cancel and leave the least ones") {
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  CHECK(sum_of({{most, most}, {3, 5}, {-most, most}}) == 15);
  CHECK(sum_of({{most, most}, {least, 1}, {most, -most}}) == least);
  CHECK(sum_of({{most, most}}) == std::numeric_limits<double>::infinity());
  CHECK(sum_of({{most, -most}}) == -std::numeric_limits<double>::infinity());
  CHECK(sum_of({{most, 1}, {most, 1}}, -1) == most);
  CHECK(sum_of({{least, least}}) == 0);
  CHECK(sum_of({{least, least}}, 1074) == least);
  CHECK(sum_of({}) == 0);
}

TEST_CASE("the order does not matter") {
  Random random(2);
  for (int run = 0; run < trials(500); ++run) {
    Products products = random_products(random, 200);
    const double sum = sum_of(products);
    random.shuffle(products);
    CHECK(sum_of(products) == sum);
  }
}

TEST_CASE("the sum of partial sums is the sum, and its digits hold all of it") {
  Random random(3);
  for (int run = 0; run < trials(500); ++run) {
    const Products products = random_products(random, 300);
    std::array<ExactSum, 3> parts;
    ExactSum whole;
    for (const auto& [a, b] : products) {
      parts[random.below(3)].add_product(a, b);
      whole.add_product(a, b);
    }
    parts[1] += parts[2];
    parts[0] += ExactSum::of(parts[1].digits());
    CHECK(parts[0].digits() == whole.digits());
    CHECK(parts[0].rounded() == whole.rounded());
  }
}

TEST_CASE("a sum may be added to itself again and again") {
  ExactSum sum;
  sum.add_product(-3, 0x1p-600);
  for (int doubled = 0; doubled < 700; ++doubled) sum += ExactSum(sum);
  CHECK(sum.rounded() == -0x3p100);
}

TEST_SUITE_END();
