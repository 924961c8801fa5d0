#include "rbpa/fill/polygons_of_rings.h"

#include <algorithm>
#include <optional>
#include <string>

#include "rbpa/core/error.h"
#include "rbpa/fill/simple_rings.h"
#include "rbpa/shape/measure.h"
#include "rbpa/shape/nesting.h"
#include "rbpa/shape/steps.h"

namespace rbpa {
namespace {

Ring reversed(const Ring& ring) { return {{ring.points.rbegin(), ring.points.rend()}}; }

}  // namespace

std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                       const std::function<bool()>& go_on) {
  const RingName name = [](std::size_t ring) { return "ring " + std::to_string(ring); };
  check_points(points, rings, name);
  const NestedRings nested = nest_rings(points, rings, name, go_on);
  if (nested.meet) throw InvalidInput(nested.meet->why + "; expected rings that do not meet");
  std::vector<Polygon> polygons;
  std::vector<std::size_t> polygon_of(rings.size());
  const auto oriented = [&](std::size_t r) {
    return nested.place[r].is_counter_clockwise == nested.place[r].is_hole() ? reversed(rings[r]) : rings[r];
  };
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (nested.place[r].is_hole()) continue;
    polygon_of[r] = polygons.size();
    polygons.push_back({.shell = oriented(r)});
  }
  for (std::size_t r = 0; r < rings.size(); ++r)
    if (nested.place[r].is_hole()) polygons[polygon_of[*nested.place[r].inside]].holes.push_back(oriented(r));
  for (Polygon& polygon : polygons) measure(polygon, points);
  return polygons;
}

std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                       std::span<const Point> in_holes, const std::function<bool()>& go_on) {
  std::vector<Polygon> polygons = polygons_of_rings(points, rings, go_on);
  // What is within a hole is as much a polygon: with the shells in it for its holes.
  std::vector<Point> all(points.begin(), points.end());
  std::vector<std::uint32_t> queries;
  for (std::size_t i = 0; i < in_holes.size(); ++i) {
    if (!is_finite(in_holes[i]))
      throw InvalidInput("hole point " + std::to_string(i) + ": found " + place_of(in_holes[i]) +
                         ", expected finite coordinates");
    queries.push_back(static_cast<std::uint32_t>(all.size()));
    all.push_back(in_holes[i]);
  }
  std::vector<Polygon> insides;
  for (const Polygon& polygon : polygons)
    for (const Ring& hole : polygon.holes) insides.push_back({.shell = reversed(hole)});
  Steps step(go_on);
  const std::vector<std::optional<HoleOf>> nested = nesting(polygons, points, step);
  std::vector<std::size_t> first_inside(polygons.size(), 0);
  for (std::size_t p = 1; p < polygons.size(); ++p)
    first_inside[p] = first_inside[p - 1] + polygons[p - 1].holes.size();
  for (std::size_t p = 0; p < polygons.size(); ++p)
    if (nested[p])
      insides[first_inside[nested[p]->polygon] + nested[p]->hole].holes.push_back(reversed(polygons[p].shell));

  std::vector<bool> has_point(insides.size(), false);
  const std::vector<std::optional<std::uint32_t>> around = polygons_around(insides, all, queries, step);
  for (std::size_t i = 0; i < in_holes.size(); ++i) {
    if (!around[i])
      throw InvalidInput("hole point " + std::to_string(i) + " at " + place_of(in_holes[i]) +
                         ": found it in no hole, expected a ring around it within another");
    has_point[*around[i]] = true;
  }
  const auto without = std::find(has_point.begin(), has_point.end(), false);
  if (without != has_point.end()) {
    const Polygon& hole = insides[static_cast<std::size_t>(without - has_point.begin())];
    throw InvalidInput("the ring through " + place_of(points[hole.shell.points[0]]) +
                       ": found it within another and no hole point in it, expected one: lines inside of a polygon are "
                       "not kept");
  }
  return polygons;
}

}  // namespace rbpa
