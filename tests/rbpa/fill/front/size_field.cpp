#include "rbpa/fill/front/size_field.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.h"

TEST_SUITE_BEGIN("fill");

TEST_CASE("the size at any place is the least of the cones over the sources") {
  rbpa_test::Random random(3);
  for (const std::size_t n : {0U, 1U, 8U, 9U, 300U}) {
    std::vector<rbpa::SizeAt> sources(n);
    for (rbpa::SizeAt& source : sources) source = {{random.unit(), random.unit()}, random.between(0.01, 0.6)};
    const double grade = random.between(0.05, 2), most = 0.5;
    const rbpa::SizeField field(most, grade, sources);
    double least = most;
    for (const rbpa::SizeAt& source : sources) least = std::min(least, source.size);
    CHECK(field.least() == least);
    for (int i = 0; i < 300; ++i) {
      const rbpa::Point p{random.between(-1, 2), random.between(-1, 2)};
      double expected = most;
      for (const rbpa::SizeAt& source : sources)
        expected = std::min(expected, source.size + grade * std::hypot(p.x - source.at.x, p.y - source.at.y));
      CHECK(field.at(p) == doctest::Approx(expected).epsilon(1e-14));
    }
  }
}

TEST_SUITE_END();
