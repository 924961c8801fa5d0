// Checks fill() by GEOS: accepted polygons are valid, and the triangles have their area.
//   --count=N   number of random sets of rings
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "oracle/geos_geometry.h"
#include "rbpa/base/error.h"
#include "rbpa/fill.h"
#include "rbpa/fill/polygons_of_rings.h"
#include "support/arguments.h"
#include "support/generate_polygons.h"
#include "support/random.h"

namespace rbpa_test {
namespace {

double area_of(const rbpa::Filling& filling) {
  double twice = 0;
  for (const auto& [a, b, c] : filling.triangles) {
    const rbpa::Point &p = filling.points[a], &q = filling.points[b], &r = filling.points[c];
    twice += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  return twice / 2;
}

}  // namespace

TEST_CASE("generated polygons are valid, and their triangles have their area") {
  for (std::size_t number = 0; number < 200; number += 3) {
    const PolygonCase made = polygon_case(number);
    INFO(made.name);
    const GeosGeometry geometry = GeosGeometry::of(made.polygons, made.points);
    CHECK(geometry.invalid() == "");
    // GEOS works with coordinates as they are: far from the origin, it has fewer digits.
    double extent = 1;
    for (const rbpa::Point& p : made.points) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
    const rbpa::Filling filling = rbpa::fill(made.points, made.polygons, {.size = made.size});
    CHECK(std::abs(geometry.area() - area_of(filling)) <= 1e-13 * extent * geometry.perimeter());
  }
}

TEST_CASE("rings that are accepted make valid polygons, and rings that GEOS calls invalid are refused") {
  Random random(2);
  const auto count = static_cast<std::size_t>(argument("count", 3000));
  std::size_t accepted = 0, invalid = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const PolygonCase made = random_rings(random, random.integer(1, 3), random.integer(3, 7), random.integer(2, 12));
    std::vector<rbpa::Ring> rings;
    for (const rbpa::Polygon& polygon : made.polygons) rings.push_back(polygon.shell);
    INFO("number ", i);
    try {
      const std::vector<rbpa::Polygon> polygons = rbpa::polygons_of_rings(made.points, rings);
      const GeosGeometry geometry = GeosGeometry::of(polygons, made.points);
      CHECK(geometry.invalid() == "");
      const rbpa::Filling filling = rbpa::fill(made.points, polygons, {.size = 2});
      CHECK(std::abs(geometry.area() - area_of(filling)) <= 1e-11);
      ++accepted;
    } catch (const rbpa::InvalidInput&) {
      // GEOS judges each polygon by itself.
      bool all_valid = true;
      for (const rbpa::Polygon& polygon : made.polygons)
        all_valid = all_valid && GeosGeometry::of({polygon}, made.points).invalid().empty();
      invalid += !all_valid;
    }
    for (const rbpa::Polygon& polygon : made.polygons) {
      if (GeosGeometry::of({polygon}, made.points).invalid().empty()) continue;
      CHECK_THROWS_AS(rbpa::fill(made.points, std::vector{polygon}, {.size = 2}), rbpa::InvalidInput);
    }
  }
  CHECK(accepted > count / 10);
  CHECK(invalid > count / 10);
}

}  // namespace rbpa_test
