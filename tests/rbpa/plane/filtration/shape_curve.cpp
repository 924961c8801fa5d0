#include "rbpa/plane/filtration/shape_curve.h"
#include "rbpa/rbpa.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "plane/filtration/small_sets.h"
#include "plane/filtration/solid_sizes.h"
#include "support/delaunay_arrays.h"
#include "support/generate.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Filtration;
using rbpa::ShapeState;
using Wide = long double;

TEST_SUITE_BEGIN("filtration");

namespace {

std::vector<ShapeState> curve_of(const Points& points) {
  const rbpa::Delaunay delaunay(points);
  const std::function<bool()> on;
  rbpa::Steps pulse(on);
  return rbpa::shape_curve(delaunay, rbpa::filtration(delaunay), pulse);
}

Wide area_of(const Points& points, const Triangle& triangle) {
  // The order of the corners matters for nearly flat triangles.
  std::array<rbpa::Point, 3> corners{points[triangle[0]], points[triangle[1]], points[triangle[2]]};
  std::sort(corners.begin(), corners.end());
  const auto& [p, q, r] = corners;
  return std::abs((Wide(q.x) - p.x) * (Wide(r.y) - p.y) - (Wide(q.y) - p.y) * (Wide(r.x) - p.x)) / 2;
}

struct Areas {
  Wide solid = 0, enclosed = 0;
};

/// Measures the complex at alpha, built anew: a region that the outside does not reach through missing sides is
/// enclosed.
Areas areas_at(const Points& points, double alpha, const std::vector<Triangle>& delaunay) {
  const auto built = rbpa::triangles(rbpa::rbpa(points, alpha));
  const std::set<Triangle> solid(built.begin(), built.end());
  std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>> beside;  // triangles at each side
  for (std::size_t t = 0; t < delaunay.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t u = delaunay[t][i], v = delaunay[t][(i + 1) % 3];
      beside[{std::min(u, v), std::max(u, v)}].push_back(t);
    }
  std::vector<bool> outside(delaunay.size());
  std::vector<std::size_t> waiting;
  const auto reach = [&](std::size_t t) {
    if (!outside[t] && !solid.contains(delaunay[t])) waiting.push_back(t);
    outside[t] = outside[t] || !solid.contains(delaunay[t]);
  };
  for (const auto& [side, triangles] : beside)
    if (triangles.size() == 1) reach(triangles[0]);
  for (std::size_t i = 0; i < waiting.size(); ++i)
    for (const auto& [side, triangles] : beside)
      if (triangles.size() == 2 && (triangles[0] == waiting[i] || triangles[1] == waiting[i]))
        for (const std::size_t t : triangles) reach(t);
  Areas areas;
  for (std::size_t t = 0; t < delaunay.size(); ++t) {
    const Wide area = area_of(points, delaunay[t]);
    if (solid.contains(delaunay[t])) areas.solid += area;
    if (!outside[t]) areas.enclosed += area;
  }
  return areas;
}

bool is_near(Wide a, Wide b) { return std::abs(a - b) <= 1e-9L * std::max(std::abs(a), std::abs(b)); }

}  // namespace

TEST_CASE("parts, holes and change at every step equal those of the complex built anew") {
  std::size_t with_holes = 0, with_parts = 0;
  on_small_sets([&](const Points& points) {
    const auto delaunay = delaunay_arrays(points);
    const std::vector<Triangle> all = delaunay.triangles;
    const Filtration filtration = rbpa::filtration(delaunay, points);
    const std::vector<ShapeState> curve = curve_of(points);
    REQUIRE(curve.size() == filtration.steps.size());
    Wide most = 0, turns = 1, before = 1, first = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      CAPTURE(filtration.steps[i].alpha);
      const Areas areas = areas_at(points, filtration.steps[i].alpha, all);
      Wide sum = 0, squares = 0;
      for (const std::size_t size : solid_sizes(rbpa::rbpa(points, filtration.steps[i].alpha).mesh)) {
        sum += static_cast<Wide>(size);
        squares += static_cast<Wide>(size * size);
      }
      CHECK(is_near(curve[i].effective_parts, sum * sum / squares));
      REQUIRE(areas.solid > 0);
      const Wide filled = areas.solid / areas.enclosed;
      CHECK(std::abs(curve[i].hole_share - (1 - filled)) < 1e-9L);
      most = std::max(most, squares);
      turns *= filled > before ? filled / before : before / filled;
      before = filled;
      const Wide change = most * turns * std::pow(areas.enclosed, Wide(1) / 8);
      if (i == 0) first = change / curve[i].change;
      CHECK(is_near(change, first * curve[i].change));
      CHECK((i == 0 || curve[i].change >= curve[i - 1].change));
      with_holes += curve[i].hole_share > 0.01;
      with_parts += curve[i].effective_parts > 2;
    }
  });
  CHECK(with_holes > 100);
  CHECK(with_parts > 100);
}

TEST_CASE("the change does not depend on the order of the points or their unit, to the last bit") {
  Random random(51);
  const auto same = [](const std::vector<ShapeState>& a, const std::vector<ShapeState>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ShapeState& s, const ShapeState& t) {
      return s.change == t.change && s.effective_parts == t.effective_parts && s.hole_share == t.hole_share;
    });
  };
  on_small_sets([&](const Points& points) {
    Points shuffled = points;
    if (!shuffled.empty()) shuffled.push_back(shuffled.back());
    random.shuffle(shuffled);
    CHECK(same(curve_of(points), curve_of(shuffled)));
  });
  for (const Points& points : {uniform(300, 52), clusters(30, 53), random_grid(20, 200, true, 54)}) {
    for (const int exponent : {-800, -1, 5, 800}) CHECK(same(curve_of(points), curve_of(scaled(points, exponent))));
    Points shuffled = points;
    random.shuffle(shuffled);
    CHECK(same(curve_of(points), curve_of(shuffled)));
  }
}

TEST_SUITE_END();
