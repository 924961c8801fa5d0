// Compares delaunay(), which completes the remainder, with CGAL.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "oracle/delaunay.h"
#include "rbpa/base/exact/magnitude.h"
#include "rbpa/plane/divide/divide_and_conquer.h"
#include "rbpa/rbpa.h"
#include "support/generate.h"
#include "support/sets.h"

namespace rbpa_test {
namespace {

std::vector<Triangle> triangles_of(const Points& points) {
  const std::vector<std::uint32_t> lowest = lowest_equal(points);
  std::vector<rbpa::SitePoint> places;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (lowest[i] == i) places.push_back({points[i], i});
  rbpa::Threads threads;
  const meshops::Patch patch = rbpa::divide_and_conquer<double>(
      places, [](const auto&...) { return 0; }, threads);
  std::vector<Triangle> found;
  for (const auto& t : patch.triangles)
    found.push_back(
        {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
  return canonical(std::move(found));
}

}  // namespace

TEST_CASE("the triangles of generated sets are those of CGAL, and of rbpa() without a radius") {
  int sets = 0;
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    if (!rbpa::fits_double(rbpa::magnitude(points))) continue;
    ++sets;
    CAPTURE(set.name);
    const std::vector<Triangle> found = triangles_of(points);
    CHECK(difference(DelaunayOracle(points).triangles(INFINITY), found) == "");
    CHECK(difference(rbpa::triangles(rbpa::rbpa(points, INFINITY)), found) == "");
  }
  CHECK(sets > 40);
}

TEST_CASE("the triangles of tens of thousands of points are those of CGAL") {
  for (const Points& points : {uniform(50000, 1), jittered_grid(200, 0.5, 2), perfect_grid(200, 1), clusters(3000, 3),
                               along_curves(8000), rounded_concentric(10000), lidar_lines(100, 300, 4)})
    CHECK(difference(DelaunayOracle(points).triangles(INFINITY), triangles_of(points)) == "");
}

}  // namespace rbpa_test
