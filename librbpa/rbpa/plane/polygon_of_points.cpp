#include "rbpa/plane/polygon_of_points.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "rbpa/base/arrays/components.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle.h"
#include "rbpa/plane/shape/nesting.h"

namespace rbpa {
namespace {

using Number = std::optional<std::uint32_t>;
/// The first edge of a shell, by input indices. The edge is on no other ring.
struct FirstEdge {
  std::uint32_t from, to, polygon;
};

/// A table that finds the polygon whose shell begins with an edge.
class PolygonsByEdge {
 public:
  PolygonsByEdge(std::span<const Polygon> polygons, Steps& step) {
    for (std::uint32_t p = 0; p < polygons.size(); ++p)
      firsts_.push_back({polygons[p].shell.points[0], polygons[p].shell.points[1], p});
    sort(firsts_, step, less);
  }

  /// Returns the polygon of an edge, or none.
  std::uint32_t of(std::uint32_t from, std::uint32_t to) const {
    const FirstEdge wanted{from, to, 0};
    const auto found = std::lower_bound(firsts_.begin(), firsts_.end(), wanted, less);
    return found != firsts_.end() && key(*found) == key(wanted) ? found->polygon : no_index;
  }

 private:
  static std::pair<std::uint32_t, std::uint32_t> key(const FirstEdge& edge) { return {edge.from, edge.to}; }
  static bool less(const FirstEdge& a, const FirstEdge& b) { return key(a) < key(b); }

  std::vector<FirstEdge> firsts_ = {};
};

/// Returns the polygon of each component, or none, at the number of the triangle that represents the component.
std::vector<std::uint32_t> polygon_of_components(const TriangleArrays& complex, const PolygonsByEdge& polygons,
                                                 meshops::DisjointSets& components, Steps& step) {
  std::vector<std::uint32_t> polygon(complex.triangles.size(), no_index);
  for (std::uint32_t t = 0; t < complex.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      step();
      if (complex.neighbors[t][k] != no_index) continue;
      const auto& corners = complex.triangles[t];
      const std::uint32_t found = polygons.of(corners[(k + 1) % 3], corners[(k + 2) % 3]);
      if (found != no_index) polygon[components.find(t)] = found;
    }
  return polygon;
}

/// Sets `of_point` to `polygon`, unless `polygon` is none, or `of_point` has a lesser number.
void put(Number& of_point, std::uint32_t polygon) {
  if (polygon != no_index && (!of_point || polygon < *of_point)) of_point = polygon;
}

/// Finds the polygons of points without a polygon in `result`: points in filled holes, and duplicates.
void complete(std::vector<Number>& result, std::span<const Duplicate> duplicates, std::span<const Polygon> polygons,
              const PolygonFilter& filter, std::span<const Point> points, Steps& step) {
  if (filter.min_hole_area > 0) {
    std::vector<bool> repeats(points.size(), false);
    for (const Duplicate& duplicate : duplicates) repeats[duplicate.index] = true;
    std::vector<std::uint32_t> left;
    std::vector<Point> queries;
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (!result[i] && !repeats[i]) {
        left.push_back(i);
        queries.push_back(points[i]);
      }
    const std::vector<Number> around = polygons_around(polygons, points, queries, step);
    for (std::size_t q = 0; q < queries.size(); ++q) result[left[q]] = around[q];
  }
  for (const Duplicate& duplicate : duplicates) result[duplicate.index] = result[duplicate.stands_for];
}

}  // namespace

std::vector<Number> polygon_of_points(std::span<const Point> points, const TriangleArrays& complex,
                                      std::span<const Duplicate> duplicates, std::span<const Polygon> polygons,
                                      const PolygonFilter& filter, const GoOn& go_on) {
  Steps step(go_on);
  std::vector<Number> result(points.size());
  {
    meshops::DisjointSets components = components_of(complex, step);
    const std::vector<std::uint32_t> polygon =
        polygon_of_components(complex, PolygonsByEdge(polygons, step), components, step);
    for (std::uint32_t t = 0; t < complex.triangles.size(); ++t) {
      step();
      const std::uint32_t here = polygon[components.find(t)];
      for (const std::uint32_t corner : complex.triangles[t]) put(result[corner], here);
    }
  }
  complete(result, duplicates, polygons, filter, points, step);
  return result;
}

std::vector<Number> polygon_of_points(std::span<const Polygon> polygons, std::span<const Point> corners,
                                      std::span<const Point> queries, const GoOn& go_on) {
  Steps step(go_on);
  std::vector<std::pair<Point, std::uint32_t>> polygon_at;  // each corner with its polygon
  polygon_at.reserve(corners.size());
  for (std::uint32_t p = 0; p < polygons.size(); ++p) {
    const auto add = [&, p](const Ring& ring) {
      for (const std::uint32_t corner : ring.points) polygon_at.emplace_back(corners[corner], p);
    };
    add(polygons[p].shell);
    std::for_each(polygons[p].holes.begin(), polygons[p].holes.end(), add);
  }
  sort(polygon_at, step, std::less<>());
  std::vector<Number> result(queries.size());
  std::vector<std::size_t> left;
  std::vector<Point> inner;
  for (std::size_t q = 0; q < queries.size(); ++q) {
    step();
    const auto found = std::lower_bound(polygon_at.begin(), polygon_at.end(), std::pair(queries[q], std::uint32_t{0}));
    if (found != polygon_at.end() && found->first == queries[q]) {
      result[q] = found->second;
      continue;
    }
    left.push_back(q);
    inner.push_back(queries[q]);
  }
  const std::vector<Number> around = polygons_around(polygons, corners, inner, step);
  for (std::size_t i = 0; i < left.size(); ++i) result[left[i]] = around[i];
  return result;
}

}  // namespace rbpa
