// Checks by GEOS which polygons fill() accepts: exactly the valid ones, also if they touch; and their area and
// boundary.
//   --count=N     number of random polygons; more, until a quarter of that number touch
//   --largest=N   only point files with at most that many points
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "oracle/geos_geometry.h"
#include "rbpa/fill.h"
#include "rbpa/fill/validity.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/rbpa.h"
#include "support/arguments.h"
#include "support/data_folder.h"
#include "support/random.h"
#include "support/read_points.h"
#include "support/spacing.h"

namespace rbpa_test {
namespace {

using rbpa::Filling;
using rbpa::Point;
using rbpa::Polygon;
using rbpa::Ring;

struct Made {
  Points points = {};
  std::vector<Polygon> polygons = {};
};

template <typename Visit>
void for_each_ring(const std::vector<Polygon>& polygons, Visit visit) {
  for (const Polygon& polygon : polygons) {
    visit(polygon.shell);
    for (const Ring& hole : polygon.holes) visit(hole);
  }
}

/// Returns one or more polygons on a small grid, so that rings touch and share edges, and vertices repeat.
Made random_polygons(Random& random) {
  Made made;
  const int side = random.integer(4, 12);
  const auto add = [&](Ring& ring, const Points& corners) {
    for (const Point& p : corners)
      for (int times = random.integer(0, 9) == 0 ? 2 : 1; times > 0; --times) {
        ring.points.push_back(static_cast<std::uint32_t>(made.points.size()));
        made.points.push_back(p);
      }
  };
  const auto anywhere = [&] { return Point{double(random.integer(0, side)), double(random.integer(0, side))}; };
  const auto small = [&](int corners) {
    const Point at = anywhere();
    Points ring;
    for (; corners > 0; --corners)
      ring.push_back({std::clamp(at.x + random.integer(-2, 2), 0.0, double(side)),
                      std::clamp(at.y + random.integer(-2, 2), 0.0, double(side))});
    return ring;
  };
  const double s = side;
  Polygon& first = made.polygons.emplace_back();
  switch (random.integer(0, 2)) {
    case 0:
      add(first.shell, {{0, 0}, {s, 0}, {s, s}, {0, s}});
      break;
    case 1:
      add(first.shell, {anywhere(), anywhere(), anywhere(), anywhere()});
      break;
    default:
      add(first.shell, {{0, 0}, {s, 0}, {double(random.integer(1, side)), double(random.integer(1, side))}, {0, s}});
  }
  for (int holes = random.integer(1, 4); holes > 0; --holes)
    add(first.holes.emplace_back(), small(random.integer(3, 4)));
  for (int more = random.integer(0, 5) - 3; more > 0; --more) add(made.polygons.emplace_back().shell, small(3));
  return made;
}

/// Returns whether a vertex of one ring is at a place of another.
bool touches(const Filling& filling) {
  std::set<std::pair<double, double>> passed;
  bool twice = false;
  for_each_ring(filling.polygons, [&](const Ring& ring) {
    for (const std::uint32_t i : ring.points)
      twice |= !passed.insert({filling.points[i].x, filling.points[i].y}).second;
  });
  return twice;
}

/// Checks area and boundary; returns "" when they are right. The boundary is the sides without a neighbor.
std::string wrong_with(const Filling& filling, const GeosGeometry& geometry, const Points& points) {
  double twice = 0, extent = 1;
  std::set<std::pair<std::uint32_t, std::uint32_t>> open, rings;
  for (std::size_t t = 0; t < filling.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = filling.triangles[t][(k + 1) % 3], to = filling.triangles[t][(k + 2) % 3];
      twice += filling.points[from].x * filling.points[to].y - filling.points[from].y * filling.points[to].x;
      if (filling.neighbors[t][k] == rbpa::TriangleArrays::none) open.insert({from, to});
    }
  for_each_ring(filling.polygons, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i)
      rings.insert({ring.points[i], ring.points[(i + 1) % ring.points.size()]});
  });
  for (const Point& p : points) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
  if (std::abs(twice / 2 - geometry.area()) > 1e-12 * extent * (geometry.perimeter() + extent)) return "another area";
  return open == rings ? "" : "the boundary is another";
}

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST_CASE("random polygons, many of which touch, are accepted exactly if GEOS calls them valid") {
  Random random(5);
  std::size_t accepted = 0, touching = 0, refused = 0;
  const auto count = static_cast<std::size_t>(argument("count", 100));
  for (std::size_t i = 0; accepted < count || touching * 4 < count; ++i) {
    const Made made = random_polygons(random);
    const GeosGeometry geometry = GeosGeometry::of(made.polygons, made.points);
    const std::string invalid = geometry.invalid();
    const std::optional<std::string> why = rbpa::why_invalid(made.points, made.polygons);
    INFO("number ", i, ": ", invalid, " | ", why.value_or("valid"));
    REQUIRE(invalid.empty() == !why);
    refused += why.has_value();
    if (why) continue;
    for (const double size : {infinity, 1.5}) {
      const Filling filling = rbpa::fill(made.points, made.polygons, {.size = size});
      REQUIRE(wrong_with(filling, geometry, made.points) == "");
      if (size == infinity) touching += touches(filling);
    }
    ++accepted;
  }
  CHECK(touching * 4 >= count);
  CHECK(refused > 0);
}

/// Fills every polygon of an alpha shape, and all of them together.
void fill_shape(const std::string& name, const Points& points, double alpha) {
  INFO(name, ", ", points.size(), " points, alpha ", alpha);
  const std::vector<Polygon> polygons = rbpa::outline_polygons(rbpa::rbpa(points, alpha));
  const GeosGeometry geometry = GeosGeometry::of(polygons, points);
  if (!geometry.invalid().empty()) return;
  const std::optional<std::string> why = rbpa::why_invalid(points, polygons);
  CHECK_MESSAGE(!why, why.value_or(""));
  if (why) return;
  const Filling filling = rbpa::fill(points, polygons, {.size = infinity});
  CHECK(wrong_with(filling, geometry, points) == "");
}

std::size_t fill_shapes(const std::filesystem::path& folder) {
  const auto largest = static_cast<std::size_t>(argument("largest", 3000));
  std::size_t sets = 0;
  for (const PointFile& file : point_files(folder)) {
    const Points points = read_points(file);
    if (points.size() > largest) continue;
    const double spacing = mean_spacing(points);
    for (const double share : {0.7, 1.4, 3.0}) fill_shape(file.name, points, share * spacing);
    ++sets;
  }
  return sets;
}

TEST_CASE("no polygon of an alpha shape of bundled point files that GEOS calls valid is refused") {
  CHECK(fill_shapes(bundled_data()) > 3);
}

TEST_CASE("further point files have no alpha shape with a polygon that GEOS calls valid and fill() refuses") {
  CHECK((fill_shapes(further_data()) > 0) == has_further_data());
}

}  // namespace
}  // namespace rbpa_test
