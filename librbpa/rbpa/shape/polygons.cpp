#include "rbpa/shape/polygons.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "meshops/front/boundary_curve.h"
#include "rbpa/core/error.h"
#include "rbpa/predicate/predicates.h"
#include "rbpa/shape/components.h"
#include "rbpa/shape/measure.h"
#include "rbpa/shape/nesting.h"
#include "rbpa/shape/split_curve.h"

namespace rbpa {
namespace {

std::size_t index(OpenMesh::VertexHandle v) { return static_cast<std::size_t>(v.idx()); }

/// The input points by index, as far as the mesh stands on them.
std::vector<Point> points_under(const SolidAlphaComplex& complex) {
  std::vector<Point> points;
  for (const std::uint32_t p : complex.input_index) points.resize(std::max(points.size(), std::size_t{p} + 1));
  for (std::size_t v = 0; v < complex.input_index.size(); ++v) {
    const auto at = complex.mesh.point(meshops::Vertex(static_cast<int>(v)));
    points[complex.input_index[v]] = {at[0], at[1]};
  }
  return points;
}

/// Rings and polygons in lexicographic order of their first two points: an edge is on one ring, and so no two compare
/// equal.
class Order {
 public:
  explicit Order(const std::vector<Point>& points) : points_(points) {}

  bool operator()(const Ring& a, const Ring& b) const { return key(a) < key(b); }
  bool operator()(const Polygon& a, const Polygon& b) const { return key(a.shell) < key(b.shell); }

  void begin_with_least(Ring& ring) const {
    const auto less = [&](std::uint32_t p, std::uint32_t q) { return points_[p] < points_[q]; };
    std::rotate(ring.points.begin(), std::min_element(ring.points.begin(), ring.points.end(), less), ring.points.end());
  }
  /// Of a ring that begins with its least point, where it cannot go straight on.
  bool is_counter_clockwise(const Ring& ring) const {
    return Predicates<long double>::orientation(points_[ring.points.back()], points_[ring.points[0]],
                                                points_[ring.points[1]]) > 0;
  }

 private:
  std::pair<Point, Point> key(const Ring& ring) const { return {points_[ring.points[0]], points_[ring.points[1]]}; }

  const std::vector<Point>& points_;
};

/// The rings of each solid component.
std::vector<std::vector<Ring>> rings_by_component(const SolidAlphaComplex& complex, std::size_t points) {
  const Mesh& mesh = complex.mesh;
  meshops::DisjointSets components = components_of(mesh);
  std::vector<std::vector<Ring>> rings;
  std::vector<std::uint32_t> number(mesh.n_vertices(), 0);  // from 1, by the least vertex
  CurveSplitter splitter(points);
  std::vector<std::uint32_t> curve;
  for (const meshops::BoundaryCurve& boundary : meshops::boundary_curves(mesh)) {
    curve.clear();
    for (const meshops::Halfedge h : boundary) curve.push_back(complex.input_index[index(mesh.to_vertex_handle(h))]);
    std::reverse(curve.begin(), curve.end());  // the mesh is on the left now
    std::uint32_t& component =
        number[components.find(static_cast<std::uint32_t>(index(mesh.to_vertex_handle(boundary.front()))))];
    if (component == 0) {
      rings.emplace_back();
      component = static_cast<std::uint32_t>(rings.size());
    }
    splitter.split(curve, rings[component - 1]);
  }
  return rings;
}

/// One of the rings runs counter-clockwise. It has the least point of all, perhaps with holes that touch it there.
Polygon polygon_of(std::vector<Ring> rings, const Order& order) {
  for (Ring& ring : rings) order.begin_with_least(ring);
  std::sort(rings.begin(), rings.end(), order);
  const auto shell =
      std::find_if(rings.begin(), rings.end(), [&](const Ring& ring) { return order.is_counter_clockwise(ring); });
  Polygon polygon{.shell = std::move(*shell)};
  rings.erase(shell);
  polygon.holes = std::move(rings);
  return polygon;
}

/// Takes holes that are too small out of their polygons, and the polygons in those holes.
void fill_holes(std::vector<Polygon>& polygons, const std::vector<Point>& points, double min_area) {
  std::vector<std::vector<bool>> filled;
  bool any = false;
  for (const Polygon& polygon : polygons) {
    std::vector<bool>& of_polygon = filled.emplace_back();
    for (const Ring& hole : polygon.holes) {
      of_polygon.push_back(enclosed_area(hole, points) < min_area);
      any = any || of_polygon.back();
    }
  }
  if (!any) return;

  const std::vector<std::optional<HoleOf>> inside = nesting(polygons, points);
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

}  // namespace

std::vector<Polygon> polygons(const SolidAlphaComplex& complex, const PolygonFilter& filter) {
  if (!(filter.min_hole_area >= 0)) throw InvalidInput("min_hole_area: expected an area, 0 or more");
  if (!(filter.min_part_area >= 0)) throw InvalidInput("min_part_area: expected an area, 0 or more");
  const std::vector<Point> points = points_under(complex);
  const Order order(points);
  std::vector<Polygon> result;
  for (std::vector<Ring>& rings : rings_by_component(complex, points.size()))
    result.push_back(polygon_of(std::move(rings), order));
  std::sort(result.begin(), result.end(), order);

  if (filter.min_hole_area > 0) fill_holes(result, points, filter.min_hole_area);
  for (Polygon& polygon : result) measure(polygon, points);
  std::erase_if(result, [&](const Polygon& polygon) { return polygon.area < filter.min_part_area; });
  return result;
}

}  // namespace rbpa
