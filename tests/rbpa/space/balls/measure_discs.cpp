#include "rbpa/space/balls/measure_discs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/space/balls/weighted_filtration.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::DiscCurve;
using rbpa::DiscMeasures;
using rbpa::measure_discs;
using rbpa::Point;
using std::numbers::pi;

TEST_SUITE_BEGIN("space");

namespace {

using doctest::Approx;

struct Discs {
  std::vector<Point> centers;
  std::vector<double> radii;
  void add(double x, double y, double radius) {
    centers.push_back({x, y});
    radii.push_back(radius);
  }
  DiscMeasures measured() const { return measure_discs(centers, radii); }
};

Discs random_discs(std::size_t count, double least, double greatest, Random& random) {
  Discs discs;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.unit(), y = random.unit();
    discs.add(x, y, random.between(least, greatest));
  }
  return discs;
}

/// Discs on an integer grid with integer radii: nested, equal and tangent discs, and points on several circles.
Discs discs_on_grid(std::size_t count, int size, Random& random) {
  Discs discs;
  for (std::size_t i = 0; i < count; ++i) {
    const int x = random.integer(0, size), y = random.integer(0, size);
    discs.add(x, y, random.integer(0, 3));
  }
  return discs;
}

struct Share {
  double area = 0, length = 0;
};

/// Returns the area that a disc around the origin shares with the triangle of the origin, p and q; negative if the
/// triangle is clockwise.
double area_in_disc(const Point& p, const Point& q, double r) {
  const double x = q.x - p.x, y = q.y - p.y, square = x * x + y * y, along = p.x * x + p.y * y;
  const double root = along * along - square * (p.x * p.x + p.y * p.y - r * r);
  const auto sector = [&](const Point& u, const Point& v) {
    return r * r * std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y) / 2;
  };
  if (!(square > 0) || root <= 0) return sector(p, q);
  const auto at = [&](double t) { return Point{p.x + t * x, p.y + t * y}; };
  const double in = (-along - std::sqrt(root)) / square, out = (-along + std::sqrt(root)) / square;
  if (out <= 0 || in >= 1) return sector(p, q);
  const Point u = at(std::max(in, 0.0)), v = at(std::min(out, 1.0));
  return (u.x * v.y - u.y * v.x) / 2 + (in > 0 ? sector(p, u) : 0) + (out < 1 ? sector(v, q) : 0);
}

/// Computes the share of disc i by definition, from all other discs: its arcs outside of them, and the area that it
/// shares with its power cell.
Share share_of(const Discs& discs, std::size_t i) {
  const auto& [centers, radii] = discs;
  const double r = radii[i];
  std::vector<std::pair<double, double>> covered;
  std::vector<Point> cell = {{-1e3, -1e3}, {1e3, -1e3}, {1e3, 1e3}, {-1e3, 1e3}};  // relative to center i
  for (std::size_t j = 0; j < centers.size(); ++j) {
    if (j == i) continue;
    const double x = centers[j].x - centers[i].x, y = centers[j].y - centers[i].y, d = std::hypot(x, y), s = radii[j];
    if (d == 0 ? s > r || (s == r && j < i) : d + r <= s) return {};
    if (d == 0) continue;
    // Points p with p · (x, y) up to `lift` have no lower power to disc j.
    const double lift = (d * d + r * r - s * s) / 2;
    std::vector<Point> clipped;
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const Point &p = cell[k], &q = cell[(k + 1) % cell.size()];
      const double over = p.x * x + p.y * y - lift, next = q.x * x + q.y * y - lift, t = over / (over - next);
      if (over <= 0) clipped.push_back(p);
      if ((over < 0 && next > 0) || (over > 0 && next < 0))
        clipped.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
    cell = std::move(clipped);
    if (d >= r + s || d + s <= r) continue;
    const double height = lift / d, reach = std::atan2(std::sqrt(std::max(r * r - height * height, 0.0)), height);
    for (const double turn : {-2 * pi, 0.0, 2 * pi})
      covered.emplace_back(std::atan2(y, x) - reach + turn, std::atan2(y, x) + reach + turn);
  }
  Share share;
  for (std::size_t k = 0; k < cell.size(); ++k) share.area += area_in_disc(cell[k], cell[(k + 1) % cell.size()], r);
  std::sort(covered.begin(), covered.end());
  double reached = -pi;
  for (const auto& [from, to] : covered) {
    if (from > reached) share.length += r * (std::min(from, pi) - std::min(reached, pi));
    reached = std::max(reached, to);
  }
  share.length += r * std::max(pi - reached, 0.0);
  return share;
}

/// Checks what holds for any discs. Sizes are compared within `tolerance`, for discs of about the size 1.
void check(const Discs& discs, const DiscMeasures& found, double tolerance) {
  double area = 0, length = 0;
  std::uint32_t components = 0;
  bool is_known = true;
  for (const DiscCurve& curve : found.boundary) {
    area += curve.area;
    length += curve.length;
    if (!curve.is_hole) ++components;
    is_known &= curve.component == components - 1;  // each component begins with its outer curve
    for (const rbpa::DiscArc& arc : curve.arcs) is_known &= found.components[arc.disc] == curve.component;
    CHECK((curve.is_hole ? curve.area <= tolerance : curve.area >= -tolerance));
    for (std::size_t k = 0; k < curve.arcs.size(); ++k) {
      const rbpa::DiscArc &arc = curve.arcs[k], &next = curve.arcs[(k + 1) % curve.arcs.size()];
      const auto at = [&](std::uint32_t disc, double angle) {
        return Point{discs.centers[disc].x + discs.radii[disc] * std::cos(angle),
                     discs.centers[disc].y + discs.radii[disc] * std::sin(angle)};
      };
      const Point end = at(arc.disc, arc.begin + arc.angle), begin = at(next.disc, next.begin);
      CHECK(std::hypot(end.x - begin.x, end.y - begin.y) <= std::sqrt(tolerance));
      CHECK(std::abs(arc.begin) <= pi);
      CHECK(arc.angle >= 0);
      CHECK(arc.angle <= 2 * pi);
    }
  }
  CHECK(is_known);
  for (const std::uint32_t i : found.hidden) CHECK(found.components[i] == DiscMeasures::none);
  CHECK(std::count(found.components.begin(), found.components.end(), DiscMeasures::none) ==
        static_cast<std::ptrdiff_t>(found.hidden.size()));
  CHECK(std::abs(area - found.area) <= tolerance);
  CHECK(std::abs(length - found.length) <= tolerance);
}

std::size_t holes_of(const DiscMeasures& measures) {
  return static_cast<std::size_t>(std::count_if(measures.boundary.begin(), measures.boundary.end(),
                                                [](const DiscCurve& curve) { return curve.is_hole; }));
}

}  // namespace

TEST_CASE("shares of discs are those of the definition") {
  Random random(1);
  for (int round = 0; round < 60; ++round) {
    const double greatest = std::array{0.08, 0.2, 0.5}[static_cast<std::size_t>(round % 3)];
    const Discs discs = round % 4 == 3 ? discs_on_grid(40, 8, random)
                                       : random_discs(static_cast<std::size_t>(1 + round), 0.01, greatest, random);
    CAPTURE(round);
    const double tolerance = round % 4 == 3 ? 1e-7 : 1e-11;  // half angles of the definition at tangent discs
    const DiscMeasures found = discs.measured();
    check(discs, found, tolerance);
    for (std::size_t i = 0; i < discs.radii.size(); ++i) {
      CAPTURE(i);
      const Share share = share_of(discs, i);
      CHECK(std::abs(found.areas[i] - share.area) <= tolerance);
      CHECK(std::abs(found.lengths[i] - share.length) <= tolerance);
    }
  }
}

TEST_CASE("components and holes of discs are Betti numbers of the weighted filtration") {
  Random random(2);
  std::size_t holes = 0;
  for (int round = 0; round < 40; ++round) {
    const Discs discs = random_discs(150, 0.01, 0.07, random);
    std::vector<rbpa::Point3> centers;
    for (const Point& p : discs.centers) centers.push_back({p.x, p.y, 0});
    const rbpa::SolidFiltration filtration = rbpa::weighted_filtration(centers, discs.radii);
    const auto within = [](const std::vector<double>& values) {
      return std::count_if(values.begin(), values.end(), [](double value) { return value <= 0; });
    };
    const DiscMeasures found = discs.measured();
    check(discs, found, 1e-11);
    holes += holes_of(found);
    const auto components = static_cast<std::ptrdiff_t>(found.boundary.size() - holes_of(found));
    CHECK(components - static_cast<std::ptrdiff_t>(holes_of(found)) ==
          within(filtration.point_alpha) - within(filtration.edge_alpha) + within(filtration.triangle_alpha));
  }
  CHECK(holes > 100);
}

TEST_CASE("one and two discs have the sizes of the formulas") {
  Discs one;
  one.add(3, -2, 1.5);
  const DiscMeasures alone = one.measured();
  CHECK(alone.area == Approx(2.25 * pi).epsilon(1e-15));
  CHECK(alone.length == Approx(3 * pi).epsilon(1e-15));
  REQUIRE(alone.boundary.size() == 1);
  CHECK(alone.boundary[0].area == Approx(2.25 * pi).epsilon(1e-15));
  CHECK(alone.boundary[0].arcs.size() == 1);
  for (const double distance : {0.25, 1.0, 1.999999999, 2.0, 3.0}) {
    CAPTURE(distance);
    Discs two;
    two.add(1e6, 1e6, 1);
    two.add(1e6, 1e6 + distance, 1);
    const double d = two.centers[1].y - two.centers[0].y;
    const double reach = d < 2 ? std::atan2(std::sqrt((1 - d / 2) * (1 + d / 2)), d / 2) : 0;
    const DiscMeasures found = two.measured();
    CHECK(found.length == Approx(4 * (pi - reach)).epsilon(1e-14));
    CHECK(found.area == Approx(2 * (pi - reach + std::sin(reach) * std::cos(reach))).epsilon(1e-14));
    CHECK(found.boundary.size() == (d < 2 ? 1 : 2));
    CHECK(found.areas[0] == Approx(found.areas[1]).epsilon(1e-14));
  }
}

TEST_CASE("hidden discs are inside others, equal to others, or meet no cell of theirs") {
  Discs discs;
  discs.add(0, 0, 5);
  discs.add(1, 0, 4);  // touches the first from inside
  discs.add(0, 0, 5);
  discs.add(0, 0, 3);
  discs.add(20, 0, 0);
  discs.add(2, 1, 0);
  const DiscMeasures found = discs.measured();
  CHECK(found.hidden == std::vector<std::uint32_t>{1, 2, 3, 5});
  CHECK(found.area == Approx(25 * pi).epsilon(1e-15));
  CHECK(found.boundary.size() == 2);
  CHECK(found.lengths[1] == 0);
  CHECK(found.areas[4] == 0);
}

TEST_CASE("circles that meet in one point leave no hole, and discs that touch there are hidden or alone") {
  Discs inside;
  inside.add(1, 0, 1);
  inside.add(0, 2, 2);  // in the next one, through the origin like all
  inside.add(0, 3, 3);
  CHECK(inside.measured().hidden == std::vector<std::uint32_t>{1});
  CHECK(inside.measured().lengths[1] == 0);
  Discs point;
  point.add(1, 0, 2);
  point.add(1, 2, 0);
  point.add(3, 2, 2);
  CHECK(point.measured().components == std::vector<std::uint32_t>{0, 1, 0});
  Discs touching;  // the first two touch in (4, 5), which two curves share
  touching.add(4, 6, 1);
  touching.add(4, 4, 1);
  touching.add(2, 6, 2);
  touching.add(6, 6, 2);
  const DiscMeasures found = touching.measured();
  check(touching, found, 1e-12);
  CHECK(found.components == std::vector<std::uint32_t>{0, 0, 0, 0});
}

TEST_CASE("a component in a hole, and a hole in that, are distinguished") {
  Discs discs;
  const auto ring = [&](double distance, int count, double radius) {
    for (int i = 0; i < count; ++i)
      discs.add(distance * std::cos(2 * pi * i / count), distance * std::sin(2 * pi * i / count), radius);
  };
  ring(100, 20, 20);
  ring(40, 12, 12);
  discs.add(0, 0, 5);
  const DiscMeasures found = discs.measured();
  check(discs, found, 1e-9);
  std::vector<std::pair<std::uint32_t, bool>> order;
  for (const DiscCurve& curve : found.boundary) order.emplace_back(curve.component, curve.is_hole);
  CHECK(order == std::vector<std::pair<std::uint32_t, bool>>{{0, false}, {0, true}, {1, false}, {1, true}, {2, false}});
  for (const DiscCurve& curve : found.boundary) CHECK((curve.area < 0) == curve.is_hole);
}

TEST_CASE("a grid of discs has a hole in each square until the discs meet in its center") {
  for (const double radius : {0.5, 0.6, 0.7, std::sqrt(0.5) + 1e-9, 0.8}) {
    CAPTURE(radius);
    Discs discs;
    for (int x = 0; x < 7; ++x)
      for (int y = 0; y < 7; ++y) discs.add(x, y, radius);
    const DiscMeasures found = discs.measured();
    check(discs, found, 1e-12);
    CHECK(holes_of(found) == (radius > 0.5 && radius < 0.705 ? 36 : 0));
    CHECK(found.boundary.size() - holes_of(found) == (radius == 0.5 ? 49 : 1));
  }
  Discs meeting;  // five units from the origin
  for (const auto& [x, y] : {std::pair{3, 4}, {-3, 4}, {-3, -4}, {3, -4}}) meeting.add(x, y, 5);
  CHECK(holes_of(meeting.measured()) == 0);
}

TEST_CASE("measures scale, and depend on order only by numbering") {
  Random random(4);
  const Discs discs = random_discs(300, 0.0, 0.05, random);
  const DiscMeasures found = discs.measured();
  for (const int exponent : {-900, -300, 300, 900}) {
    CAPTURE(exponent);
    Discs scaled;
    const int part = exponent / 2;  // areas must fit
    for (std::size_t i = 0; i < discs.radii.size(); ++i)
      scaled.add(std::ldexp(discs.centers[i].x, part), std::ldexp(discs.centers[i].y, part),
                 std::ldexp(discs.radii[i], part));
    const DiscMeasures other = scaled.measured();
    CHECK(std::ldexp(other.area, -2 * part) == Approx(found.area).epsilon(1e-14));
    CHECK(std::ldexp(other.length, -part) == Approx(found.length).epsilon(1e-14));
    CHECK(other.boundary.size() == found.boundary.size());
  }
  std::vector<std::size_t> order(discs.radii.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  random.shuffle(order);
  Discs shuffled;
  for (const std::size_t i : order) shuffled.add(discs.centers[i].x, discs.centers[i].y, discs.radii[i]);
  const DiscMeasures other = shuffled.measured();
  CHECK(other.area == Approx(found.area).epsilon(1e-15));
  for (std::size_t i = 0; i < order.size(); ++i) {
    CHECK(other.areas[i] == Approx(found.areas[order[i]]).epsilon(1e-13));
    CHECK(other.lengths[i] == Approx(found.lengths[order[i]]).epsilon(1e-13));
  }
}

TEST_CASE("polygons of discs are within the discs and approach their areas") {
  Random random(5);
  Discs discs = random_discs(100, 0.02, 0.1, random);
  discs.add(3, 3, 0);
  const DiscMeasures found = discs.measured();
  double last = std::numeric_limits<double>::infinity();
  for (const unsigned corners : {8U, 64U, 512U}) {
    const rbpa::DiscPolygons made = rbpa::disc_polygons(found, discs.centers, discs.radii, corners);
    std::size_t rings = 0;
    for (const rbpa::Polygon& polygon : made.polygons) rings += 1 + polygon.holes.size();
    CHECK(rings == found.boundary.size() - 1);
    CHECK(made.points.size() < 100 * (corners + 6));
    const rbpa::PolygonTotals totals = rbpa::total(made.polygons);
    CHECK(totals.area < found.area);
    CHECK(totals.perimeter < found.length);
    for (const rbpa::Polygon& polygon : made.polygons)
      for (std::size_t h = 1; h < polygon.holes.size(); ++h)
        CHECK(made.points[polygon.holes[h - 1].points[0]] <= made.points[polygon.holes[h].points[0]]);
    CHECK(found.area - totals.area < last / 30);
    last = found.area - totals.area;
  }
  CHECK_THROWS_AS(rbpa::disc_polygons(found, discs.centers, discs.radii, 2), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::disc_polygons(found, {}, {}, 8), meshops::ContractViolation);
}

TEST_CASE("wrong discs are refused, no discs have no size") {
  const DiscMeasures none = measure_discs({}, {});
  CHECK(none.area == 0);
  CHECK(none.boundary.empty());
  Discs discs;
  discs.add(0, 0, -1);
  CHECK_THROWS_WITH_AS(discs.measured(), doctest::Contains("radius 0 is -1"), rbpa::InvalidInput);
  discs.radii = {};
  CHECK_THROWS_WITH_AS(discs.measured(), doctest::Contains("0 radii"), rbpa::InvalidInput);
  Random random(6);
  const Discs many = random_discs(20'000, 0.001, 0.01, random);
  CHECK_THROWS_AS(measure_discs(many.centers, many.radii, {.progress = [](const rbpa::Progress&) { return false; }}),
                  rbpa::Cancelled);
}

TEST_SUITE_END();
