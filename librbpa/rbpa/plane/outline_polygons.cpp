#include "rbpa/plane/outline_polygons.h"

#include <algorithm>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/arrays/boundary_walk.h"
#include "rbpa/base/arrays/components.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/plane/shape/measure.h"
#include "rbpa/plane/shape/nesting.h"
#include "rbpa/plane/shape/polygons_of_linked.h"
#include "rbpa/plane/shape/split_curve.h"

namespace rbpa {
namespace {

/// The lexicographic order of rings, and of polygons, by the first two points. Each edge is on one ring, so no two are
/// equal.
class Order {
 public:
  explicit Order(std::span<const Point> points) : points_(points) {}

  bool operator()(const Ring& a, const Ring& b) const { return key(a) < key(b); }
  bool operator()(const Polygon& a, const Polygon& b) const { return key(a.shell) < key(b.shell); }

  void begin_with_least(Ring& ring) const {
    const auto less = [&](std::uint32_t p, std::uint32_t q) { return points_[p] < points_[q]; };
    std::rotate(ring.points.begin(), std::min_element(ring.points.begin(), ring.points.end(), less), ring.points.end());
  }
  /// Returns whether a ring that begins with its lexicographically least point, at which it always turns, is
  /// counter-clockwise.
  bool is_counter_clockwise(const Ring& ring) const {
    return Predicates<long double>::orientation(points_[ring.points.back()], points_[ring.points[0]],
                                                points_[ring.points[1]]) > 0;
  }

 private:
  std::pair<Point, Point> key(const Ring& ring) const { return {points_[ring.points[0]], points_[ring.points[1]]}; }

  std::span<const Point> points_;
};

/// A collector of the rings of each component.
class RingsByComponent {
 public:
  /// Prepares for curves on points below `points`, of components whose names are below `names`.
  RingsByComponent(std::size_t points, std::size_t names) : splitter_(points), number_(names, 0) {}

  /// Adds a boundary curve of the component `component`, with the complex on the left.
  void add(std::span<const std::uint32_t> curve, std::uint32_t component) {
    std::uint32_t& number = number_[component];
    if (number == 0) {
      rings_.emplace_back();
      number = static_cast<std::uint32_t>(rings_.size());
    }
    splitter_.split(curve, rings_[number - 1]);
  }
  std::vector<std::vector<Ring>> take() { return std::move(rings_); }

 private:
  CurveSplitter splitter_;
  std::vector<std::uint32_t> number_;  // for each name, the number of its component, from 1; 0: no curve yet
  std::vector<std::vector<Ring>> rings_;
};

std::vector<std::vector<Ring>> rings_by_component(const TriangleArrays& complex, std::size_t points, Steps& step) {
  const auto triangles = static_cast<std::uint32_t>(complex.triangles.size());
  meshops::DisjointSets components = components_of(complex, step);
  RingsByComponent rings(points, triangles);
  BoundaryWalk walk(complex);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    step();
    for (std::size_t across = 0; across < 3; ++across) {
      if (!walk.is_new({t, across})) continue;
      std::vector<std::uint32_t> curve = walk.curve_from({t, across});
      std::reverse(curve.begin(), curve.end());  // the triangles are on the left now
      step(curve.size());
      rings.add(curve, components.find(t));
    }
  }
  return rings.take();
}

/// Returns the polygon of the rings of a component. Its shell is the one counter-clockwise ring, which has the
/// lexicographically least point of all rings; holes may touch the shell there.
Polygon polygon_of(std::vector<Ring> rings, const Order& order, Steps& step) {
  for (Ring& ring : rings) {
    step(ring.points.size());
    order.begin_with_least(ring);
  }
  sort(rings, step, order);
  const auto shell =
      std::find_if(rings.begin(), rings.end(), [&](const Ring& ring) { return order.is_counter_clockwise(ring); });
  meshops::require(shell != rings.end(), "polygons: the complex is of other points than those given");
  Polygon polygon{.shell = std::move(*shell)};
  rings.erase(shell);
  polygon.holes = std::move(rings);
  return polygon;
}

/// Removes holes that are too small from their polygons, and the polygons in those holes.
void fill_holes(std::vector<Polygon>& polygons, std::span<const Point> points, double min_area, Steps& step) {
  std::vector<std::vector<bool>> filled;
  bool any = false;
  for (const Polygon& polygon : polygons) {
    std::vector<bool>& of_polygon = filled.emplace_back();
    for (const Ring& hole : polygon.holes) {
      step(hole.points.size());
      of_polygon.push_back(enclosed_area(hole, points) < min_area);
      any = any || of_polygon.back();
    }
  }
  if (!any) return;

  const std::vector<std::optional<HoleOf>> inside = nesting(polygons, points, step);
  std::vector<Polygon> kept;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    bool covered = false;
    for (auto hole = inside[p]; hole && !covered; hole = inside[hole->polygon])
      covered = filled[hole->polygon][hole->hole];
    if (covered) continue;
    Polygon& polygon = kept.emplace_back(Polygon{.shell = std::move(polygons[p].shell)});
    for (std::size_t h = 0; h < polygons[p].holes.size(); ++h)
      if (!filled[p][h]) polygon.holes.push_back(std::move(polygons[p].holes[h]));
  }
  polygons = std::move(kept);
}

void check(const PolygonFilter& filter) {
  const auto check_area = [](const char* name, double area) {
    if (!(area >= 0)) throw InvalidInput(name + (": found " + text(area)) + ", expected an area, 0 or more");
  };
  check_area("min_hole_area", filter.min_hole_area);
  check_area("min_part_area", filter.min_part_area);
}

/// Applies the filter, and measures the polygons.
void apply(const PolygonFilter& filter, std::vector<Polygon>& polygons, std::span<const Point> points, Steps& step) {
  if (filter.min_hole_area > 0) fill_holes(polygons, points, filter.min_hole_area, step);
  for (Polygon& polygon : polygons) {
    step(polygon.shell.points.size());
    for (const Ring& hole : polygon.holes) step(hole.points.size());
    measure(polygon, points);
  }
  std::erase_if(polygons, [&](const Polygon& polygon) { return polygon.area < filter.min_part_area; });
}

std::vector<Polygon> polygons_of(std::vector<std::vector<Ring>> components, std::span<const Point> points,
                                 const PolygonFilter& filter, Steps& step) {
  const Order order(points);
  std::vector<Polygon> result;
  for (std::vector<Ring>& rings : components) result.push_back(polygon_of(std::move(rings), order, step));
  sort(result, step, order);
  apply(filter, result, points, step);
  return result;
}

}  // namespace

std::vector<Polygon> outline_polygons(std::span<const Point> points, const TriangleArrays& complex,
                                      const PolygonFilter& filter, const GoOn& go_on) {
  check(filter);
  require_linked(complex, points.size(), go_on);
  return polygons_of_linked(points, complex, filter, go_on);
}

std::vector<Polygon> polygons_of_linked(std::span<const Point> points, const TriangleArrays& complex,
                                        const PolygonFilter& filter, const GoOn& go_on) {
  check(filter);
  Steps step(go_on);
  return polygons_of(rings_by_component(complex, points.size(), step), points, filter, step);
}

void filter_polygons(std::vector<Polygon>& polygons, std::span<const Point> points, const PolygonFilter& filter,
                     const GoOn& go_on) {
  check(filter);
  Steps step(go_on);
  apply(filter, polygons, points, step);
}

}  // namespace rbpa
