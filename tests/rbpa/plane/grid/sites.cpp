#include "rbpa/plane/grid/sites.h"

#include <doctest/doctest.h>

#include <map>
#include <vector>

#include "support/generate.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::Sites;

TEST_SUITE_BEGIN("search");

namespace {

struct Less {
  bool operator()(const Point& a, const Point& b) const { return a < b; }
};

void check_sites(const Points& input) {
  rbpa::Threads one;
  const Sites sites(input, one);
  std::map<Point, std::uint32_t, Less> first;
  std::vector<rbpa::Duplicate> duplicates;
  for (std::uint32_t i = 0; i < input.size(); ++i)
    if (const auto [found, is_new] = first.insert({input[i], i}); !is_new) duplicates.push_back({i, found->second});
  REQUIRE(sites.size() == first.size());
  REQUIRE(sites.input_index().size() == sites.size());
  for (std::size_t s = 0; s < sites.size(); ++s) {
    const Point p = sites.at(s);
    CHECK(first.at(p) == sites.input_index()[s]);
    first.erase(p);
  }
  CHECK(first.empty());
  CHECK(sites.duplicates() == duplicates);
}

Points repeated(Points points, std::uint64_t seed) {
  Random random(seed);
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; i += 3) points.push_back(points[random.below(count)]);
  random.shuffle(points);
  return points;
}

}  // namespace

TEST_CASE("every distinct point is a site at the given place, with the lowest of its indices") {
  check_sites({});
  check_sites({{0, 0}, {-0.0, 0}, {0, -0.0}});
  Points wide = uniform(200, 1);
  for (const Point& p : {Point{1e200, 0}, Point{0.5, 1e-200}, Point{-1e300, 1e300}, Point{0.5, 3e-310}})
    wide.push_back(p);
  for (const Points& points : {uniform(300, 2), scaled(uniform(300, 3), 700), scaled(uniform(300, 4), -900), wide,
                               mixed_exponents(50, 5), far_and_tiny(40, 6), corners_of_range(), denormals(20, 80, 7)})
    check_sites(repeated(points, 8));
}

TEST_CASE("no two sites are farther apart than the bound, however they are scaled") {
  rbpa::Threads one;
  for (const Points& points :
       {uniform(50, 9), scaled(uniform(50, 10), -800), mixed_exponents(10, 11), corners_of_range()}) {
    const Sites sites(points, one);
    const auto size = [](long double d) { return d < 0 ? -d : d; };
    for (const Point& p : points)
      for (const Point& q : points) {
        const long double dx = size(static_cast<long double>(p.x) - q.x),
                          dy = size(static_cast<long double>(p.y) - q.y);
        CHECK(dx + dy <= sites.diameter_bound());
      }
  }
}

TEST_SUITE_END();
