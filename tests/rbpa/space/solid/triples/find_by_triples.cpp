// Tetrahedra from the triples around each point, compared with the definition: every four points, and every fifth.
#include "rbpa/space/solid/triples/find_by_triples.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/space/cells/scaled_points.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/sphere.h"
#include "support/arguments.h"
#include "support/space_sets.h"

using rbpa::Point3;
using rbpa::Threads;
using rbpa::space::Cells;
using rbpa::space::find_by_triples;
using rbpa::space::Site;
using rbpa::space::Triples;
using namespace rbpa_test;

TEST_SUITE_BEGIN("space");

namespace {

using Corners = std::array<Site, 4>;

/// Returns the corners ascending, except the last two, which are exchanged where the permutation is odd.
Corners canonical(const Corners& t) {
  Corners sorted = t;
  std::sort(sorted.begin(), sorted.end());
  bool is_odd = false;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) is_odd ^= t[j] < t[i];
  if (is_odd) std::swap(sorted[2], sorted[3]);
  return sorted;
}

std::vector<Corners> canonical(std::vector<Corners> all) {
  for (Corners& t : all) t = canonical(t);
  std::sort(all.begin(), all.end());
  return all;
}

/// Returns every four points whose sphere has a radius of at most alpha and contains no fifth.
std::vector<Corners> by_definition(std::span<const Point3> sites, double alpha) {
  std::vector<Corners> all;
  const auto count = static_cast<Site>(sites.size());
  const auto is_empty = [&](const Corners& t) {
    for (Site p = 0; p < count; ++p)
      if (std::find(t.begin(), t.end(), p) == t.end() &&
          rbpa::space::in_sphere(sites[t[0]], sites[t[1]], sites[t[2]], sites[t[3]], sites[p]))
        return false;
    return true;
  };
  for (Site a = 0; a < count; ++a)
    for (Site b = a + 1; b < count; ++b)
      for (Site c = b + 1; c < count; ++c)
        for (Site d = c + 1; d < count; ++d) {
          Corners t = {a, b, c, d};
          const int side = rbpa::space::exact::orientation(sites[a], sites[b], sites[c], sites[d]);
          if (side < 0) std::swap(t[2], t[3]);
          if (side != 0 &&
              rbpa::space::exact::compare_circumradius(sites[t[0]], sites[t[1]], sites[t[2]], sites[t[3]], alpha) <=
                  0 &&
              is_empty(t))
            all.push_back(t);
        }
  return all;
}

struct Found {
  std::vector<Corners> tetrahedra;
  std::size_t exact;
};

/// Finds the tetrahedra in `parts` parts of the cells.
Found found_in_parts(const Cells& cells, double alpha, std::size_t parts) {
  Found all{{}, 0};
  for (std::size_t part = 0; part < parts; ++part) {
    Triples found;
    REQUIRE(
        find_by_triples(cells, alpha, part * cells.size() / parts, (part + 1) * cells.size() / parts, SIZE_MAX, found));
    all.tetrahedra.insert(all.tetrahedra.end(), found.tetrahedra.begin(), found.tetrahedra.end());
    all.exact += found.exact;
  }
  return all;
}

}  // namespace

TEST_CASE("the tetrahedra follow the definition, whatever is degenerate") {
  Random random(3101);
  std::size_t compared = 0, exact = 0;
  for (int trial = 0; trial < trials(1500); ++trial) {
    const auto kind = static_cast<SpaceKind>(random.below(space_kinds));
    CAPTURE(name(kind));
    CAPTURE(trial);
    const Points3 points = space_set(kind, 4 + random.below(12), random);
    const double alpha = space_radius(points, random) * (random.chance(0.3) ? 2 : 1);
    if (!(alpha > 0) || !std::isfinite(2 * alpha)) continue;
    const rbpa::space::ScaledPoints scaled(points, alpha);
    if (!scaled.fits_double()) continue;
    Threads threads(1);
    const Cells cells(scaled.points(), 2 * scaled.radius(), threads);
    const Found found = found_in_parts(cells, scaled.radius(), 1 + random.below(3));
    const std::vector<Corners> expected = by_definition(cells.sites(), scaled.radius());
    REQUIRE(canonical(found.tetrahedra) == canonical(expected));
    compared += expected.size();
    exact += found.exact;
  }
  CHECK(compared > 1000);
  CHECK(exact > 500);
}

TEST_CASE("points in general position need no exact arithmetic") {
  Random random(3102);
  const Points3 points = space_set(SpaceKind::cube, 3000, random);
  for (const double spacings : {0.6, 0.8, 1.0}) {
    const double alpha = spacings * 2 / std::cbrt(3000.0);  // the cube has sides of length 2
    Threads threads(1);
    const Cells cells(points, 2 * alpha, threads);
    const Found found = found_in_parts(cells, alpha, 1);
    CHECK(found.exact <= 1);
    CHECK(found.tetrahedra.size() > 1000);
    for (const auto& [a, b, c, d] : found.tetrahedra)
      CHECK(rbpa::space::orientation(cells.sites()[a], cells.sites()[b], cells.sites()[c], cells.sites()[d]) > 0);
  }
}

TEST_CASE("find_by_triples() gives up where too much needs exact decisions, or too many points are around one") {
  const Points3 grid = corners_of_bricks(6, 6, 6);
  Threads threads(1);
  const Cells cells(grid, 2, threads);
  Triples found;
  CHECK_FALSE(find_by_triples(cells, 1, 0, cells.size(), 10, found));
  CHECK(found.exact > 10);
  CHECK(find_by_triples(cells, 1, 0, cells.size(), SIZE_MAX, found));
  CHECK(found.tetrahedra.size() >= 5 * 5 * 5 * 5);

  Random random(3103);
  const Points3 dense = space_set(SpaceKind::cube, 5000, random);
  const Cells one(dense, 100, threads);
  CHECK_FALSE(find_by_triples(one, 50, 0, one.size(), SIZE_MAX, found));
}

TEST_CASE("the cost of triples depends on the number of near points, in a volume and on a surface") {
  Random random(6200);
  for (const bool is_flat : {false, true}) {
    CAPTURE(is_flat);
    Points3 points;
    for (int i = 0; i < 4000; ++i) {
      const double x = random.between(0, is_flat ? 63 : 16), y = random.between(0, is_flat ? 63 : 16);
      points.push_back({x, y, is_flat ? 0.1 * std::sin(x) : random.between(0, 16)});
    }
    for (const double alpha : {0.6, 1.0, 1.6}) {
      CAPTURE(alpha);
      rbpa::Threads one(1);
      const rbpa::space::Cells cells(points, 2 * alpha, one);
      double expected = 0;
      for (const Point3& p : points) {
        const auto near = static_cast<double>(std::count_if(points.begin(), points.end(), [&](const Point3& q) {
          return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) <= 2 * alpha;
        }));
        expected += 100 + near * (4 + 0.68 * near);
      }
      const double ratio = rbpa::space::triples_cost(cells) / expected;
      CHECK(ratio > 0.75);
      CHECK(ratio < 1.4);
    }
  }
}

TEST_SUITE_END();
