#include "rbpa/filling_values.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/base/exact/hypotenuse.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/fill.h"
#include "rbpa/plane/predicate/plane_predicates.h"

namespace rbpa {
namespace {

constexpr std::uint32_t none = TriangleArrays::none;

double length_between(const Point& p, const Point& q) { return hypotenuse(p.x - q.x, p.y - q.y); }

/// Sets the values of points that were inserted on the edges of a ring, between two given points.
void interpolate_edges(std::span<const Point> points, const Ring& ring, std::size_t given, std::vector<double>& value) {
  const std::size_t size = ring.points.size();
  const auto at = [&](std::size_t i) { return ring.points[i % size]; };
  std::size_t first = 0;
  while (first < size && at(first) >= given) ++first;
  if (first == size) return;  // no given point on the ring: nothing to interpolate between
  for (std::size_t a = first; a < first + size;) {
    std::size_t b = a + 1;
    while (at(b) >= given) ++b;
    const std::uint32_t from = at(a), to = at(b);
    for (std::size_t i = a + 1; i < b; ++i) {
      const double before = length_between(points[from], points[at(i)]),
                   behind = length_between(points[at(i)], points[to]);
      value[at(i)] = value[from] + (value[to] - value[from]) * (before / (before + behind));
    }
    a = b;
  }
}

/// An edge of a triangulation, from its lexicographically least end, and the triangle above the edge.
struct SweepEdge {
  Point from, to;
  std::uint32_t above;
};

/// Orders edges from below to above at an x that both cover. Requires: edges meet in their ends only.
struct IsBelow {
  using is_transparent = void;
  bool operator()(const SweepEdge& a, const SweepEdge& b) const {
    if (b.from < a.from) return turn(b, a) < 0;
    return turn(a, b) > 0;
  }
  bool operator()(const Point& p, const SweepEdge& edge) const { return plane_orientation(edge.from, edge.to, p) < 0; }
  bool operator()(const SweepEdge& edge, const Point& p) const { return !(*this)(p, edge); }

 private:
  /// Returns 1 if `other` lies above `edge`, −1 if below, 0 if equal. Requires: `other` does not begin before `edge`.
  static int turn(const SweepEdge& edge, const SweepEdge& other) {
    const int begin = plane_orientation(edge.from, edge.to, other.from);
    return begin != 0 ? begin : plane_orientation(edge.from, edge.to, other.to);
  }
};

/// Returns for each query point, given by its index, a triangle that contains the point: `none` outside of all
/// triangles. Sweeps over the points from left to right.
std::vector<std::uint32_t> triangles_around(std::span<const Point> points, const TriangleArrays& arrays,
                                            std::span<const std::uint32_t> queries, Steps& step) {
  std::vector<SweepEdge> edges;
  for (std::uint32_t t = 0; t < arrays.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &a = points[arrays.triangles[t][(k + 1) % 3]], &b = points[arrays.triangles[t][(k + 2) % 3]];
      if (a < b)
        edges.push_back({a, b, t});
      else if (arrays.neighbors[t][k] == none)
        edges.push_back({b, a, none});
    }
  std::vector<std::uint32_t> by_end(edges.size()), by_place(queries.size()), found(queries.size(), none);
  for (std::uint32_t i = 0; i < edges.size(); ++i) by_end[i] = i;
  for (std::uint32_t i = 0; i < queries.size(); ++i) by_place[i] = i;
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
  std::sort(by_end.begin(), by_end.end(), [&](auto i, auto j) { return edges[i].to < edges[j].to; });
  const auto place = [&](std::uint32_t query) { return points[queries[query]]; };
  std::sort(by_place.begin(), by_place.end(), [&](auto i, auto j) { return place(i) < place(j); });

  std::set<SweepEdge, IsBelow> crossed;
  std::size_t begun = 0, ended = 0;
  for (const std::uint32_t query : by_place) {
    const Point p = place(query);
    // At a vertex, edges end before others begin.
    while (begun < edges.size() && edges[begun].from < p) {
      step();
      while (ended < begun && !(edges[begun].from < edges[by_end[ended]].to)) crossed.erase(edges[by_end[ended++]]);
      crossed.insert(edges[begun++]);
    }
    for (; ended < begun && edges[by_end[ended]].to < p; ++ended) crossed.erase(edges[by_end[ended]]);
    const auto above = crossed.upper_bound(p);
    if (above != crossed.begin()) found[query] = std::prev(above)->above;
  }
  return found;
}

double value_in(const std::array<Point, 3>& at, const std::array<double, 3>& value, const Point& p) {
  const auto area = [](const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const std::array<double, 3> weight = {area(at[1], at[2], p), area(at[2], at[0], p), area(at[0], at[1], p)};
  const double sum = weight[0] + weight[1] + weight[2];
  return value[0] + (value[1] - value[0]) * (weight[1] / sum) + (value[2] - value[0]) * (weight[2] / sum);
}

}  // namespace

std::vector<double> values_on_filling(const Filling& filling, std::span<const double> values,
                                      std::span<const std::size_t> groups, const GoOn& go_on) {
  if (values.size() > filling.boundary_points)
    throw InvalidInput("values: found " + std::to_string(values.size()) + ", expected at most " +
                       std::to_string(filling.boundary_points) + ", one for each point given to fill()");
  Steps step(go_on);
  std::vector<double> value(values.begin(), values.end());
  value.resize(filling.points.size(), std::numeric_limits<double>::quiet_NaN());
  for (const Polygon& polygon : filling.polygons) {
    interpolate_edges(filling.points, polygon.shell, values.size(), value);
    for (const Ring& hole : polygon.holes) interpolate_edges(filling.points, hole, values.size(), value);
  }
  if (filling.boundary_points == filling.points.size()) return value;

  const std::size_t count = std::max<std::size_t>(groups.size(), 1);
  std::vector<std::vector<std::uint32_t>> inside(count);
  std::vector<bool> is_taken(filling.points.size(), false);
  for (std::size_t t = 0; t < filling.triangles.size(); ++t)
    for (const std::uint32_t i : filling.triangles[t]) {
      if (i < filling.boundary_points || is_taken[i]) continue;
      is_taken[i] = true;
      inside[filling.groups[t]].push_back(i);
    }
  const auto boundary = std::span(filling.points).first(filling.boundary_points);
  for (std::size_t g = 0; g < count; ++g) {
    if (inside[g].empty()) continue;
    const std::size_t first = groups.empty() ? 0 : groups[g],
                      last = g + 1 < groups.size() ? groups[g + 1] : filling.polygons.size();
    const Filling coarse = fill(boundary, std::span(filling.polygons).subspan(first, last - first),
                                {.size = std::numeric_limits<double>::infinity(), .progress = on_progress_of(go_on)});
    const std::vector<std::uint32_t> around = triangles_around(filling.points, coarse, inside[g], step);
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Triangle& corner = coarse.triangles[around[i]];
      const auto& p = filling.points;
      value[inside[g][i]] = value_in({p[corner[0]], p[corner[1]], p[corner[2]]},
                                     {value[corner[0]], value[corner[1]], value[corner[2]]}, p[inside[g][i]]);
    }
  }
  return value;
}

}  // namespace rbpa
