#include "rbpa/space/surface/curve_kinds.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "meshops/core/contract.h"
#include "support/spiral.h"

using namespace rbpa_test;
using rbpa::CurveKind;
using rbpa::Hole;
using rbpa::Point3;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

struct Sheet {
  Points3 points, normals;

  void add(const Point3& p, const Point3& normal) {
    points.push_back(p);
    normals.push_back(normal);
  }
};

/// Returns the kinds of its curves, the longest first; checks that they are the same in any order of the points.
std::vector<CurveKind> kinds_of(Sheet sheet, double radius) {
  Random random(7);
  std::vector<CurveKind> first;
  for (int trial = 0; trial < 4; ++trial) {
    const Surface surface = rbpa::surface(sheet.points, sheet.normals, radius);
    const std::vector<Hole> curves = rbpa::holes(sheet.points, sheet.normals, radius, surface);
    const auto kinds = rbpa::curve_kinds(sheet.points, rbpa::surface_components(sheet.points, surface), curves);
    REQUIRE(kinds.size() == curves.size());
    std::vector<std::pair<double, CurveKind>> by_length;
    for (std::size_t i = 0; i < curves.size(); ++i) by_length.emplace_back(-curves[i].length, kinds[i]);
    std::sort(by_length.begin(), by_length.end());
    std::vector<CurveKind> found;
    for (const auto& [length, kind] : by_length) found.push_back(kind);
    if (trial == 0) first = found;
    CHECK(found == first);
    for (std::size_t i = sheet.points.size(); i > 1; --i) {
      const std::size_t j = random.below(i);
      std::swap(sheet.points[i - 1], sheet.points[j]);
      std::swap(sheet.normals[i - 1], sheet.normals[j]);
    }
  }
  return first;
}

/// Returns a square of side 20 at z = 0, without the points for which `is_left_out` returns true.
template <typename LeftOut>
Sheet square(const LeftOut& is_left_out) {
  Sheet sheet;
  for (int x = 0; x <= 20; ++x)
    for (int y = 0; y <= 20; ++y)
      if (!is_left_out(x, y)) sheet.add({double(x), double(y), 0.001 * x * y}, {0, 0, 1});
  return sheet;
}

/// Returns points of the unit sphere between two heights, about 0.1 apart.
Sheet zone(double low, double high) {
  Sheet sheet;
  for (const Point3& p : spiral(1500))
    if (low <= p.z && p.z <= high) sheet.add(p, p);
  return sheet;
}

using Kinds = std::vector<CurveKind>;

}  // namespace

TEST_CASE("a sheet ends at its rim, and missing parts inside are holes, however large") {
  CHECK(kinds_of(square([](int, int) { return false; }), 1) == Kinds{CurveKind::rim});
  const auto is_near = [](int x, int y, int reach) { return std::abs(x - 10) < reach && std::abs(y - 10) < reach; };
  CHECK(kinds_of(square([&](int x, int y) { return is_near(x, y, 3); }), 1) == Kinds{CurveKind::rim, CurveKind::hole});
  CHECK(kinds_of(square([&](int x, int y) { return is_near(x, y, 8); }), 1) == Kinds{CurveKind::rim, CurveKind::hole});
}

TEST_CASE("half a sphere has a rim, a sphere with an opening a hole, and a tube two holes") {
  CHECK(kinds_of(zone(0, 1), 0.15) == Kinds{CurveKind::rim});
  CHECK(kinds_of(zone(-1, 0.7), 0.15) == Kinds{CurveKind::hole});
  CHECK(kinds_of(zone(-0.3, 0.3), 0.15) == Kinds{CurveKind::hole, CurveKind::hole});
  CHECK(kinds_of(zone(-1, 1), 0.15).empty());
}

TEST_CASE("a curve of a component that is less than a hundredth of the largest is an island") {
  Sheet sheet = square([](int, int) { return false; });
  for (const Point3& p : {Point3{30, 0, 0}, Point3{31, 0, 0}, Point3{30, 1, 0}}) sheet.add(p, {0, 0, 1});
  CHECK(kinds_of(sheet, 1) == Kinds{CurveKind::rim, CurveKind::island});
  const Surface surface = rbpa::surface(sheet.points, sheet.normals, 1);
  CHECK(rbpa::islands(rbpa::surface_components(sheet.points, surface)) == std::vector<bool>{false, true});
  // Three such components alone are ordinary pieces.
  Sheet alone;
  for (const double x : {0.0, 10.0, 20.0})
    for (const Point3& p : {Point3{x, 0, 0}, Point3{x + 1, 0, 0}, Point3{x, 1, 0}}) alone.add(p, {0, 0, 1});
  CHECK(kinds_of(alone, 1) == Kinds{CurveKind::rim, CurveKind::rim, CurveKind::rim});
}

TEST_CASE("kinds do not depend on the place or the size, where areas are in the range of double") {
  for (const double scale : {1e-140, 1.0, 1e140}) {
    CAPTURE(scale);
    Sheet sheet = zone(-1, 0.7);
    for (Point3& p : sheet.points) p = {p.x * scale, p.y * scale, p.z * scale};
    CHECK(kinds_of(sheet, 0.15 * scale) == Kinds{CurveKind::hole});
  }
}

TEST_CASE("curves are chosen by kind, edges and length") {
  const auto curve = [](std::size_t edges, double length) { return Hole{std::vector<rbpa::RimEdge>(edges), length}; };
  const std::vector<Hole> curves = {curve(3, 1), curve(4, 2), curve(5, 3), curve(6, 4)};
  const Kinds kinds = {CurveKind::hole, CurveKind::rim, CurveKind::hole, CurveKind::island};
  CHECK(rbpa::chosen_curves(curves, kinds) == std::vector<Hole>{curves[0], curves[2]});
  CHECK(rbpa::chosen_curves(curves, kinds, {.most_edges = 4}) == std::vector<Hole>{curves[0]});
  CHECK(rbpa::chosen_curves(curves, kinds, {.most_length = 2, .rims = true}) ==
        std::vector<Hole>{curves[0], curves[1]});
  CHECK(rbpa::chosen_curves(curves, kinds, {.rims = true}) == curves);
  CHECK_THROWS_AS(rbpa::chosen_curves(curves, {}), meshops::ContractViolation);
}

TEST_CASE("curves of another surface are refused") {
  const Sheet sheet = zone(0, 1);
  const Surface surface = rbpa::surface(sheet.points, sheet.normals, 0.15);
  const auto components = rbpa::surface_components(sheet.points, surface);
  std::vector<Hole> curves = rbpa::holes(sheet.points, sheet.normals, 0.15, surface);
  CHECK_THROWS_AS(rbpa::curve_kinds({}, components, curves), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::curve_kinds(sheet.points, {}, curves), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::curve_kinds(sheet.points, {{}, components.number}, curves), meshops::ContractViolation);
  curves.emplace_back();
  CHECK_THROWS_AS(rbpa::curve_kinds(sheet.points, components, curves), meshops::ContractViolation);
}

TEST_SUITE_END();
