#include "rbpa/base/exact/expansion.h"

#include <doctest/doctest.h>

#include <cmath>

#include "oracle/rational.h"
#include "support/arguments.h"
#include "support/random.h"

using namespace rbpa_test;

TEST_SUITE_BEGIN("predicates");

namespace {

template <int N>
Rational value(const rbpa::Expansion<N>& e) {
  Rational sum = 0;
  for (int i = 0; i < e.size; ++i) sum += rational(e.component[static_cast<unsigned>(i)]);
  return sum;
}

/// Returns whether the components are nonzero and ascend, and the set bits of each end above the first bit of the one
/// before.
template <int N>
bool is_well_formed(const rbpa::Expansion<N>& e) {
  for (int i = 0; i < e.size; ++i) {
    const double c = e.component[static_cast<unsigned>(i)];
    if (c == 0 || !std::isfinite(c)) return false;
    if (i == 0) continue;
    const double before = e.component[static_cast<unsigned>(i - 1)];
    const double power = std::ldexp(1.0, std::ilogb(before) + 1);  // above |before|: c must be a multiple of it
    if (std::fmod(c, power) != 0) return false;
  }
  return e.size <= N;
}

/// Returns a double whose bits come in runs: such numbers carry and cancel most.
double run_of_bits(Random& random) {
  double sum = std::ldexp(1.0, random.integer(0, 40));
  for (int i = random.integer(0, 3); i > 0; --i)
    sum += random.integer(-1, 1) * std::ldexp(1.0, random.integer(-12, 40));
  if (random.chance(0.3)) sum = random.between(-1, 1);
  return std::ldexp(sum, random.integer(-60, 60));
}

template <int N>
void check(const rbpa::Expansion<N>& e, const Rational& expected) {
  CHECK(is_well_formed(e));
  CHECK(value(e) == expected);
  CHECK(e.sign() == expected.sign());
}

}  // namespace

TEST_CASE("sums, differences and products of expansions are exact and well formed") {
  Random random(11);
  for (int trial = 0; trial < trials(4000); ++trial) {
    const double a = run_of_bits(random), b = run_of_bits(random), c = run_of_bits(random), d = run_of_bits(random);
    const auto e = rbpa::difference(a, b), f = rbpa::difference(c, random.chance(0.3) ? a : d);
    const Rational ev = value(e), fv = value(f);
    check(e, rational(a) - rational(b));
    check(-e, -ev);
    check(e + f, ev + fv);
    check(e - f, ev - fv);
    check(e * d, ev * rational(d));
    const auto product = e * f;
    check(product, ev * fv);
    const auto determinant = e * f - rbpa::difference(c, b) * rbpa::difference(d, a);
    const Rational dv = ev * fv - (rational(c) - rational(b)) * (rational(d) - rational(a));
    check(determinant, dv);
    check(determinant * product - product * determinant, 0);
    check(determinant * product - f * e * e, dv * ev * fv - fv * ev * ev);
  }
}

TEST_CASE("the expansion of zero has no component") {
  CHECK(rbpa::difference(3.5, 3.5).size == 0);
  CHECK(rbpa::difference(0.0, -0.0).size == 0);
  const auto e = rbpa::difference(1.0, 0x1p-60);
  CHECK((e - e).size == 0);
  CHECK((e * 0.0).size == 0);
  CHECK((e * rbpa::difference(2.0, 2.0)).sign() == 0);
}

TEST_SUITE_END();
