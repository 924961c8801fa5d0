// Compares natural neighbor interpolation with CGAL's coordinates.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "oracle/cgal_natural_neighbors.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/locate.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/random.h"
#include "support/sets.h"
#include "support/triangle.h"

namespace rbpa_test {
namespace {

TEST_CASE("values of generated sets are the sums of CGAL's coordinates times the values of the points") {
  Random random(51);
  std::size_t compared = 0;
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    Points points = set.make();
    if (points.size() > argument("points", 60)) points.resize(argument("points", 60));
    const auto before = [](const rbpa::Point& p, const rbpa::Point& q) {
      return std::pair(p.x, p.y) < std::pair(q.x, q.y);
    };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const rbpa::AlphaComplex of =
        rbpa::alpha_complex(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
    const rbpa::Locator locator(points, of);
    std::vector<double> values;
    for (std::size_t i = 0; i < points.size(); ++i) values.push_back(random.between(-1, 1));
    Points queries;
    for (const auto& t : of.triangles) {
      const rbpa::Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
      const double u = random.between(0.1, 0.4), v = random.between(0.1, 0.4), w = 1 - u - v;
      queries.push_back({u * a.x + v * b.x + w * c.x, u * a.y + v * b.y + w * c.y});
    }
    const auto found = locator.find(queries);
    const auto result = locator.interpolate(values, 1, queries, {.method = rbpa::Interpolation::natural_neighbor});
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (found[i] == rbpa::AlphaComplex::none) continue;
      double expected = 0;
      for (const auto& [point, share] : natural_neighbor_coordinates(points, queries[i]))
        expected += share * values[point];
      CHECK(std::abs(result[i] - expected) < 1e-8);
      ++compared;
    }
  }
  CHECK(compared > 1000);
}

}  // namespace
}  // namespace rbpa_test
