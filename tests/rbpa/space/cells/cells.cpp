#include "rbpa/space/cells/cells.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "oracle/rational.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Threads;
using rbpa::space::Cells;
using rbpa::space::Site;

TEST_SUITE_BEGIN("space");

namespace {

bool within_two_radii(const Point3& p, const Point3& q, double radius) {
  const Rational x = rational(p.x) - rational(q.x), y = rational(p.y) - rational(q.y),
                 z = rational(p.z) - rational(q.z);
  return x * x + y * y + z * z <= 4 * rational(radius) * rational(radius);
}

/// Checks that every distinct point is one site of one cell, and that all sites within two radii are around it.
void check(const Points3& points, double radius) {
  Threads threads;
  const Cells cells(points, radius, threads);
  const auto sites = cells.sites();
  Cells::Around around(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::set<Site> met;
    around.for_each_run(i, [&](Site first, Site last) {
      CHECK(first < last);
      for (Site p = first; p < last; ++p) CHECK(met.insert(p).second);
    });
    CHECK(cells.first_in(i) < cells.first_in(i + 1));
    for (Site p = cells.first_in(i); p < cells.first_in(i + 1); ++p) {
      CHECK(cells.cell_of(p) == i);
      for (Site q = 0; q < sites.size(); ++q)
        if (within_two_radii(sites[p], sites[q], radius)) CHECK(met.contains(q));
    }
  }
  CHECK(cells.first_in(cells.size()) == sites.size());

  // All input points; of equal ones the lowest index is first.
  std::map<Point3, std::vector<std::uint32_t> > expected, found;
  for (std::uint32_t i = 0; i < points.size(); ++i) expected[points[i]].push_back(i);
  for (Site p = 0; p < sites.size(); ++p) found[sites[p]].push_back(cells.input_index()[p]);
  CHECK(found.size() == sites.size());
  for (const auto& [site, index] : cells.equals()) found[sites[site]].push_back(index);
  CHECK(found == expected);
  CHECK(std::is_sorted(cells.equals().begin(), cells.equals().end(),
                       [](const Cells::Equal& e, const Cells::Equal& f) { return e.site < f.site; }));
}

}  // namespace

TEST_CASE("the cells around a point's cell hold all points within two radii") {
  Random random(71);
  for (int trial = 0; trial < 150; ++trial) {
    Points3 points =
        space_set(static_cast<SpaceKind>(random.integer(0, space_kinds - 1)), 1 + random.below(40), random);
    const double radius = space_radius(points, random);
    for (std::size_t i = random.below(4); i > 0; --i) points.push_back(points[random.below(points.size())]);
    check(points, radius);
  }
}

TEST_CASE("cells are right for points as far apart, and as near, as doubles can be") {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const Points3 points = {{most, -most, 0},      {-most, most, least},
                          {0, least, -least},    {2 * least, 0, 0},
                          {0x1p-500, 1, 0x1p57}, {1, 1, std::nextafter(0x1p57, 0)},
                          {1, 1, 0x1p57},        {1, 1, std::nextafter(0x1p57, 0x1p58)}};
  for (const double radius : {least, 0x1p-500, 1.0, 0x1.04p0, 8.0, 0x1p60, most / 4, most}) check(points, radius);
}

TEST_CASE("two points exactly two radii apart find each other wherever they lie") {
  for (const double start : {0.0, 1.0, 1.99, -0.01, 1e6, 0x1p40, -0x1p52 + 1})
    for (const double radius : {0.5, 1.0, 3.0})
      check({{start, 0, 0}, {start + 2 * radius, 0, 0}, {0, start, -2 * radius}, {0, start, 0}}, radius);
}

TEST_CASE("many points, also shuffled, have the same cells in the same order with any number of threads") {
  Random random(72);
  Points3 points = space_set(SpaceKind::cube, 60'000, random);
  for (std::size_t i = 0; i < 100; ++i) points.push_back(points[100 * i]);
  const auto in_order = [](const Points3& of, double radius, unsigned count) {
    Threads threads(count);
    const Cells cells(of, radius, threads);
    std::vector<Points3> result(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (Site p = cells.first_in(i); p < cells.first_in(i + 1); ++p) result[i].push_back(cells.sites()[p]);
      std::sort(result[i].begin(), result[i].end());
    }
    return result;
  };
  for (const double radius : {0.02, 0.3}) {
    const std::vector<Points3> expected = in_order(points, radius, 1);
    CHECK(in_order(points, radius, 2) == expected);
    random.shuffle(points);
    CHECK(in_order(points, radius, 5) == expected);
  }
  Threads threads;
  CHECK(Cells(Points3{}, 1, threads).size() == 0);
}

TEST_SUITE_END();
