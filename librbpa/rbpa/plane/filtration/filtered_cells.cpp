#include "rbpa/plane/filtration/filtered_cells.h"

#include <algorithm>
#include <limits>

#include "rbpa/base/arrays/distinct.h"
#include "rbpa/plane/filtration/least_alpha.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// An edge of the triangulation: the side of `triangle` across from corner `corner`, and the triangle beyond, or none.
struct Side {
  std::uint32_t triangle, corner, beyond;
};

/// Calls visit(Side) for each edge once, from the triangle with the smaller number.
template <typename Visit>
void for_each_edge(const AlphaComplex& delaunay, Visit visit) {
  for (std::uint32_t t = 0; t < delaunay.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (const std::uint32_t beyond = delaunay.neighbors[t][k]; beyond > t)
        visit(Side{t, k, beyond});  // `none` is the greatest number
}

/// Returns the corner of the triangle beyond that is not an end of the side.
std::uint32_t opposite(const AlphaComplex& delaunay, const Side& side) {
  const auto& across = delaunay.neighbors[side.beyond];
  const auto k = static_cast<std::size_t>(std::find(across.begin(), across.end(), side.triangle) - across.begin());
  return delaunay.triangles[side.beyond][k];
}

/// Returns whether a point lies inside the circle with the edge ab as its diameter. Only the two apexes of the edge are
/// tested: if any point is inside, one of the apexes is.
bool has_point_in_circle(const AlphaComplex& delaunay, std::span<const Point> points, const Side& side, const Point& a,
                         const Point& b) {
  using Wide = Predicates<long double>;
  if (Wide::dot_sign(points[delaunay.triangles[side.triangle][side.corner]], a, b) < 0) return true;
  return side.beyond != AlphaComplex::none && Wide::dot_sign(points[opposite(delaunay, side)], a, b) < 0;
}

/// Returns the cells of points on a line: edges join neighbors on the line, each with half its length as alpha.
FilteredCells cells_on_line(const AlphaComplex& delaunay, std::span<const Point> points,
                            const std::vector<std::uint32_t>& number, Steps& pulse) {
  std::vector<std::uint32_t> line = delaunay.isolated;
  sort(line, pulse, [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  FilteredCells cells;
  cells.vertices.assign(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    pulse();
    cells.edges.push_back({least_alpha(points[line[i - 1]], points[line[i]]),
                           {number[line[i - 1]], number[line[i]]},
                           {cells.outside(), cells.outside()}});
  }
  return cells;
}

}  // namespace

DistinctPoints distinct_points(const Delaunay& delaunay) {
  DistinctPoints distinct;
  distinct.index.reserve(delaunay.triangulation().distinct);
  distinct.number.resize(delaunay.points().size());
  for_each_distinct(distinct.number.size(), delaunay.triangulation().duplicates, [&](std::uint32_t i) {
    distinct.number[i] = static_cast<std::uint32_t>(distinct.index.size());
    distinct.index.push_back(i);
  });
  return distinct;
}

FilteredCells filtered_cells(const Delaunay& of, const DistinctPoints& distinct, const Filtration& filtration,
                             ComplexKind kind, Steps& pulse) {
  const AlphaComplex& delaunay = of.triangulation();
  const std::span<const Point> points = of.points();
  const std::vector<std::uint32_t>& number = distinct.number;
  if (delaunay.triangles.empty())
    return kind == ComplexKind::full ? cells_on_line(delaunay, points, number, pulse) : FilteredCells();

  const std::vector<double>& alpha = filtration.triangle_alpha;
  FilteredCells cells;
  cells.faces = alpha;
  cells.vertices.assign(delaunay.distinct, kind == ComplexKind::full ? 0.0 : never);
  cells.edges.reserve(delaunay.distinct + delaunay.triangles.size());
  for_each_edge(delaunay, [&](const Side& side) {
    pulse();
    const auto& corners = delaunay.triangles[side.triangle];
    const std::uint32_t from = corners[(side.corner + 1) % 3], to = corners[(side.corner + 2) % 3];
    const bool is_inner = side.beyond != AlphaComplex::none;
    FilteredCells::Edge edge{
        .alpha = is_inner ? std::min(alpha[side.triangle], alpha[side.beyond]) : alpha[side.triangle],
        .ends = {number[from], number[to]},
        .sides = {side.triangle, is_inner ? side.beyond : cells.outside()}};
    if (kind == ComplexKind::full) {
      // An edge with no point inside its diametral circle appears at half its length, any other edge with its first
      // triangle. The circle is tested last: on grids, where right angles are the rule, both radii are equal.
      const double half = least_alpha(points[from], points[to]);
      if (half != edge.alpha && !has_point_in_circle(delaunay, points, side, points[from], points[to]))
        edge.alpha = half;
    } else {
      for (const std::uint32_t v : edge.ends) cells.vertices[v] = std::min(cells.vertices[v], edge.alpha);
    }
    cells.edges.push_back(edge);
  });
  return cells;
}

}  // namespace rbpa
