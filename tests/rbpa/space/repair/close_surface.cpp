#include "rbpa/space/repair/close_surface.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "rbpa/base/error.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/surface/split_fans.h"
#include "support/order.h"
#include "support/space_sets.h"
#include "support/spiral.h"

using namespace rbpa_test;
using rbpa::ClosedSurface;
using rbpa::Point3;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

struct Lump {
  Points3 points, normals;
};

/// Returns points on a dented sphere with noise, without the points near some places; optionally rounded to a grid as
/// coarse as their spacing.
Lump lump(Random& random, bool on_grid) {
  Lump lump;
  const int count = random.integer(150, 900);
  const double dent = random.unit(), noise = random.chance(0.5) ? 0 : 0.08 * random.unit();
  Points3 gaps;
  for (int gap = random.integer(0, 4); gap > 0; --gap)
    gaps.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
  for (int k = 0; k < count; ++k) {
    const double h = 1 - (2.0 * k + 1) / count, angle = k * 2.399963229728653, s = std::sqrt(1 - h * h);
    const double r = 1 + dent * std::sin(4 * angle) * s * h + noise * (random.unit() - 0.5);
    Point3 p = {r * s * std::cos(angle), r * s * std::sin(angle), r * h};
    const bool is_gone = std::any_of(gaps.begin(), gaps.end(), [&](const Point3& gap) {
      return std::hypot(p.x - gap.x, p.y - gap.y, p.z - gap.z) < 0.4;
    });
    if (is_gone) continue;
    if (on_grid) p = {std::round(p.x * 16) / 16, std::round(p.y * 16) / 16, std::round(p.z * 16) / 16};
    lump.points.push_back(p);
    lump.normals.push_back({s * std::cos(angle), s * std::sin(angle), h});
  }
  return lump;
}

bool is_closed(const Surface& surface) {
  return std::all_of(surface.neighbors.begin(), surface.neighbors.end(), [](const auto& across) {
    return std::find(across.begin(), across.end(), Surface::none) == across.end();
  });
}

std::ptrdiff_t count_of(const std::vector<bool>& which, bool value) {
  return std::count(which.begin(), which.end(), value);
}

}  // namespace

TEST_CASE("the closed surface crosses nothing, and kept triangles are unchanged and in their order") {
  Random random(95);
  std::size_t closed = 0, gave_up = 0;
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    const Lump of = lump(random, i % 3 == 0);
    const Surface open = rbpa::indexable_surface(rbpa::surface(of.points, of.normals, 0.3));
    const ClosedSurface found = rbpa::close_surface(of.points, open);
    REQUIRE(found.kept.size() == open.triangles.size());
    REQUIRE(found.is_new.size() == found.surface.triangles.size());
    CHECK(count_of(found.kept, false) == static_cast<std::ptrdiff_t>(found.given_up));
    CHECK(count_of(found.is_new, false) == count_of(found.kept, true));
    CHECK(std::is_sorted(found.surface.triangles.begin(), found.surface.triangles.end()));
    std::size_t next = 0;
    for (std::size_t t = 0; t < open.triangles.size(); ++t) {
      if (!found.kept[t]) continue;
      while (found.is_new[next]) ++next;
      CHECK(found.surface.triangles[next++] == open.triangles[t]);
    }
    CHECK(rbpa::crossing_triangles(of.points, found.surface.triangles, 1).empty());
    const bool all_filled = std::all_of(found.holes.begin(), found.holes.end(), [](const rbpa::HoleFill& hole) {
      return hole.outcome == rbpa::HoleOutcome::filled;
    });
    if (found.given_up > 0) CHECK(is_closed(found.surface));
    CHECK(is_closed(found.surface) == all_filled);
    CHECK(static_cast<double>(found.given_up) <= 0.05 * static_cast<double>(open.triangles.size()));
    closed += is_closed(found.surface);
    gave_up += found.given_up > 0;
  }
  CHECK(closed > 20);
  CHECK(gave_up > 2);
}

TEST_CASE("a closed surface is unchanged, and the order of points does not matter") {
  Random random(96);
  for (int i = 0; i < 6; ++i) {
    CAPTURE(i);
    const Lump of = lump(random, false);
    const ClosedSurface found =
        rbpa::close_surface(of.points, rbpa::indexable_surface(rbpa::surface(of.points, of.normals, 0.3)));
    if (is_closed(found.surface)) {
      const ClosedSurface again = rbpa::close_surface(of.points, found.surface);
      const auto touching = rbpa::touching_points(of.points, found.surface);
      if (count_of(touching, true) == 0) CHECK(again.surface.triangles == found.surface.triangles);
    }
    const std::vector<std::uint32_t> order = random_order(of.points.size(), random);
    const Lump shuffled{in_order(of.points, order), in_order(of.normals, order)};
    const ClosedSurface other = rbpa::close_surface(
        shuffled.points, rbpa::indexable_surface(rbpa::surface(shuffled.points, shuffled.normals, 0.3)));
    const auto as_places = [](const Points3& points, const Surface& surface) {
      std::vector<std::array<Point3, 3>> places;
      for (const auto& t : surface.triangles) {
        std::array<Point3, 3> corners = {points[t[0]], points[t[1]], points[t[2]]};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        places.push_back(corners);
      }
      std::sort(places.begin(), places.end());
      return places;
    };
    CHECK(as_places(shuffled.points, other.surface) == as_places(of.points, found.surface));
    CHECK(other.given_up == found.given_up);
  }
}

TEST_CASE("closing can be cancelled, and an empty surface stays empty") {
  Lump of;  // two thirds of a sphere
  for (const Point3& p : spiral(1000))
    if (p.z < 0.3) of.points.push_back(p);
  of.normals = of.points;
  const Surface open = rbpa::indexable_surface(rbpa::surface(of.points, of.normals, 0.3));
  REQUIRE_FALSE(is_closed(open));
  CHECK_THROWS_AS(rbpa::close_surface(of.points, open, {.progress = [](const rbpa::Progress&) { return false; }}),
                  rbpa::Cancelled);
  const ClosedSurface none = rbpa::close_surface({}, {});
  CHECK(none.surface.triangles.empty());
  CHECK(none.holes.empty());
}

TEST_SUITE_END();
