#include "rbpa/space/surface/outliers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "rbpa/base/error.h"
#include "support/arguments.h"
#include "support/order.h"
#include "support/random.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::OutlierOptions;
using rbpa::Point3;

TEST_SUITE_BEGIN("space");

namespace {

/// Finds the outliers by sorting all distances, in extended precision.
std::vector<std::uint32_t> by_definition(const Points3& points, const OutlierOptions& options) {
  const std::set<Point3> distinct(points.begin(), points.end());
  if (distinct.size() < 2) return {};
  const auto distance = [&](const Point3& p) {
    std::vector<long double> all;
    for (const Point3& q : distinct)
      if (!(q == p)) {
        const long double x = static_cast<long double>(q.x) - p.x, y = static_cast<long double>(q.y) - p.y,
                          z = static_cast<long double>(q.z) - p.z;
        all.push_back(x * x + y * y + z * z);
      }
    std::sort(all.begin(), all.end());
    return all[std::min(options.neighbors, all.size()) - 1];
  };
  std::vector<long double> sorted;
  for (const Point3& p : distinct) sorted.push_back(distance(p));
  std::sort(sorted.begin(), sorted.end());
  const long double most = static_cast<long double>(options.factor) * options.factor * sorted[sorted.size() / 2];
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (distance(points[i]) > most) found.push_back(i);
  return found;
}

/// Returns points of integers, whose squares are not rounded, some of them far out.
Points3 integer_points(std::size_t count, Random& random) {
  Points3 points(count);
  for (Point3& p : points) {
    const int side = random.chance(0.1) ? 200 : 12;
    p = {static_cast<double>(random.integer(0, side)), static_cast<double>(random.integer(0, side)),
         static_cast<double>(random.integer(0, side))};
  }
  return points;
}

}  // namespace

TEST_CASE("outliers follow the definition") {
  Random random(101);
  std::size_t found = 0;
  for (int i = 0; i < trials(400); ++i) {
    const Points3 points = integer_points(random.below(60), random);
    const OutlierOptions options{.factor = random.between(1, 5), .neighbors = 1 + random.below(10), .threads = 1};
    const std::vector<std::uint32_t> outliers = rbpa::outliers(points, options).points;
    REQUIRE(outliers == by_definition(points, options));
    found += outliers.size();
  }
  CHECK(found > 100);
}

TEST_CASE("order, threads and a power of two change outliers only by their unit") {
  Random random(102);
  Points3 points = integer_points(3000, random);
  const rbpa::Outliers whole = rbpa::outliers(points, {.threads = 1});
  REQUIRE(whole.points.size() > 100);
  CHECK(rbpa::outliers(points, {.threads = 3}).points == whole.points);
  for (const int exponent : {-900, -3, 900}) {
    Points3 scaled = points;
    for (Point3& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    const rbpa::Outliers other = rbpa::outliers(scaled);
    CHECK(other.points == whole.points);
    CHECK(other.distance == std::ldexp(whole.distance, exponent));
  }
  const std::vector<std::uint32_t> order = random_order(points.size(), random);
  const Points3 shuffled = in_order(points, order);
  std::vector<std::uint32_t> named;
  for (const std::uint32_t i : rbpa::outliers(shuffled).points) named.push_back(order[i]);
  std::sort(named.begin(), named.end());
  CHECK(named == whole.points);
}

TEST_CASE("few points, equal points, and coordinates at both limits of double have the right outliers") {
  CHECK(rbpa::outliers({}).points.empty());
  CHECK(rbpa::outliers(Points3(9, {1, 2, 3})).points.empty());
  CHECK(rbpa::outliers(Points3{{0, 0, 0}, {1e300, 0, 0}}).points.empty());
  Points3 line;
  for (int i = 0; i < 50; ++i) line.push_back({i * 1e-300, 0, 0});
  line.push_back({1e300, 0, 0});
  line.push_back({1e300, 0, 0});
  const rbpa::Outliers found = rbpa::outliers(line);
  CHECK(found.points == std::vector<std::uint32_t>{50, 51});
  CHECK(found.distance == doctest::Approx(4e-300));
}

TEST_CASE("an invalid factor, number of neighbors or point is refused; progress can cancel") {
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const double factor : {0.5, -1.0, std::nan("")})
    CHECK_THROWS_AS(rbpa::outliers(points, {.factor = factor}), rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::outliers(points, {.neighbors = 0}), rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::outliers(Points3{{0, 0, std::nan("")}}), rbpa::InvalidInput);
  Random random(103);
  const Points3 many = integer_points(20000, random);
  CHECK_THROWS_AS(rbpa::outliers(many, {.progress = [](const rbpa::Progress&) { return false; }}), rbpa::Cancelled);
}

TEST_SUITE_END();
