#include "rbpa/space/balls/periodic_topology.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/error.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/balls/full/edges.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/outside_of_balls.h"
#include "rbpa/space/balls/periodic/parts.h"
#include "rbpa/space/predicate/outer_faces.h"
#include "rbpa/space/solid/boundary/measures.h"

namespace rbpa {
namespace {

using space::Boxes;
constexpr Boxes nowhere = {0, 0, 0};

Triangle outer_face(const PeriodicSolid& solid, std::uint32_t t, std::size_t k) {
  return space::outer_face(solid.simplices[t], k);
}

/// Returns by how many boxes the neighbor across from corner k of tetrahedron t must be moved to share the face with t.
Boxes step_across(const PeriodicSolid& solid, std::uint32_t t, std::size_t k) {
  const std::uint32_t common = solid.simplices[t][space::outer_faces[k][0]];
  const auto& beyond = solid.simplices[solid.neighbors[t][k]];
  if (std::find(beyond.begin(), beyond.end(), common) != beyond.end()) return nowhere;  // nearly always
  const PeriodicVertex& here = solid.vertices[common];
  for (const std::uint32_t corner : beyond) {
    const PeriodicVertex& there = solid.vertices[corner];
    if (there.point == here.point)
      return {here.offset[0] - there.offset[0], here.offset[1] - there.offset[1], here.offset[2] - there.offset[2]};
  }
  return nowhere;
}

Point3 minus(const Point3& p, const std::array<std::int8_t, 3>& offset, const Point3& box) {
  return {p.x - offset[0] * box.x, p.y - offset[1] * box.y, p.z - offset[2] * box.z};
}

/// Returns the image of a triangle whose least corner is in the box, starting at that corner: equal for all images.
std::array<Point3, 3> in_box(const PeriodicSolid& solid, const Triangle& triangle) {
  const auto wrapped = [&](std::uint32_t v) { return minus(solid.positions[v], solid.vertices[v].offset, solid.box); };
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (wrapped(triangle[i]) < wrapped(triangle[least])) least = i;
  const auto& offset = solid.vertices[triangle[least]].offset;
  const auto corner = [&](std::size_t i) {
    return minus(solid.positions[triangle[(least + i) % 3]], offset, solid.box);
  };
  return {corner(0), corner(1), corner(2)};
}

/// A closed surface around some tetrahedra at their places. First come the triangles that bound the tetrahedra; then,
/// for each two neighbors that do not meet because one is an image, a triangle of each.
class Hull {
 public:
  explicit Hull(const PeriodicSolid& solid) : solid_(solid), measure_(solid.positions) {}

  /// Replaces the surface. is_bounding(t, k) returns whether the triangle across from corner k of t is in the boundary.
  template <typename IsBounding>
  void enclose(std::span<const std::uint32_t> tetrahedra, const IsBounding& is_bounding) {
    triangles_.clear();
    for (const std::uint32_t t : tetrahedra)
      for (std::size_t k = 0; k < 4; ++k)
        if (is_bounding(t, k)) triangles_.push_back(outer_face(solid_, t, k));
    bounding_ = triangles_.size();
    for (const std::uint32_t t : tetrahedra)
      for (std::size_t k = 0; k < 4; ++k)
        if (!is_bounding(t, k) && step_across(solid_, t, k) != nowhere) triangles_.push_back(outer_face(solid_, t, k));
  }

  std::span<const Triangle> bounding() const { return std::span(triangles_).first(bounding_); }

  /// Returns the volume inside, the area of the bounding triangles, and the least bounding triangle.
  space::ClosedMeasures measures() const {
    std::vector<std::uint32_t> which(triangles_.size());
    std::iota(which.begin(), which.end(), std::uint32_t{0});
    if (which.empty()) return {};
    space::ClosedMeasures result = measure_.of(triangles_, which);
    which.resize(bounding_);
    result.area = which.empty() ? 0 : measure_.of(triangles_, which).area;
    for (std::size_t i = 0; i < bounding_; ++i) {
      const auto triangle = in_box(solid_, triangles_[i]);
      if (i == 0 || triangle < result.least) result.least = triangle;
    }
    return result;
  }

 private:
  const PeriodicSolid& solid_;
  space::Measures measure_;
  std::vector<Triangle> triangles_;
  std::size_t bounding_ = 0;
};

std::vector<std::uint32_t> points_of(const PeriodicSolid& solid, std::span<const Triangle> triangles) {
  std::vector<std::uint32_t> points;
  points.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t corner : triangle) points.push_back(solid.vertices[corner].point);
  sort_unique(points);
  points.shrink_to_fit();
  return points;
}

/// The full complex or the solid one: marks of the tetrahedra inside, and the triangles that separate voids.
struct Complex {
  const PeriodicSolid& delaunay;
  std::vector<bool> is_inside;
  std::optional<space::FacesWithin> faces = {};  // faces of the full complex; absent for the solid one

  bool has_triangle(std::uint32_t t, std::size_t k) const {
    return faces ? faces->has_triangle(t, k) : is_inside[t] || is_inside[delaunay.neighbors[t][k]];
  }
  bool has_edge(std::span<const space::EdgeAt> ring) const {
    if (faces) return faces->has_edge(ring);
    return std::any_of(ring.begin(), ring.end(), [&](const auto& at) { return is_inside[at.tetrahedron]; });
  }
  /// Returns whether the triangle across from corner k of t bounds a piece or a void.
  bool is_bounding(std::uint32_t t, std::size_t k) const {
    return is_inside[delaunay.neighbors[t][k]] != is_inside[t] || (!is_inside[t] && has_triangle(t, k));
  }
};

void count_simplices(const Complex& of, Threads& threads, const GoOn& go_on, PeriodicTopology& topology) {
  const auto& neighbors = of.delaunay.neighbors;
  for (std::uint32_t t = 0; t < neighbors.size(); ++t) {
    topology.tetrahedra += of.is_inside[t] ? 1u : 0u;
    for (std::size_t k = 0; k < 4; ++k) {
      topology.boundary_triangles += of.is_inside[t] && !of.is_inside[neighbors[t][k]] ? 1u : 0u;
      topology.triangles += t < neighbors[t][k] && of.has_triangle(t, k) ? 1u : 0u;
    }
  }
  const space::EdgeCounts edges = space::count_edges(
      space::Triangulated(of.delaunay), threads, [&](std::span<const space::EdgeAt> ring) { return of.has_edge(ring); },
      go_on);
  topology.edges = edges.edges;
  topology.points = of.faces ? of.delaunay.distinct : edges.points;
  topology.betti[0] = topology.points - edges.joined;
}

/// Finds the Betti numbers of the complex. By duality, b₂ is that of one-dimensional cohomology of the torus relative
/// to the outside: one class for each void but one, and one for each direction in which no void percolates.
void find_betti(const space::Parts& parts, PeriodicTopology& topology) {
  auto& [b0, b1, b2, b3] = topology.betti;
  if (topology.points == 0) return;
  b3 = topology.voids.empty() ? 1 : 0;
  b2 = topology.voids.empty() ? 3 : topology.voids.size() + 2 - parts.directions_outside().value();
  b1 = b0 + b2 + topology.edges + topology.tetrahedra - b3 - topology.points - topology.triangles;
}

/// Returns, for each part that is a void, its volume outside of the balls.
std::vector<double> outside_of_balls(const Complex& of, const space::Parts& parts, double alpha, Threads& threads,
                                     const GoOn& go_on) {
  PeriodicSolid space;
  std::vector<std::uint32_t> void_of;
  space.vertices = of.delaunay.vertices;
  space.positions = of.delaunay.positions;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    if (of.is_inside[parts.tetrahedra(i).front()]) continue;
    for (const std::uint32_t t : parts.tetrahedra(i)) {
      auto& row = space.neighbors.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) row[k] = of.has_triangle(t, k) ? Solid::none : 0;
      space.simplices.push_back(of.delaunay.simplices[t]);
      void_of.push_back(i);
    }
  }
  return space::outside_of_balls(space::Triangulated(space), void_of, parts.size(), alpha, threads, go_on);
}

}  // namespace

PeriodicTopology periodic_topology(const PeriodicSolid& delaunay, std::span<const double> radii, double alpha,
                                   ComplexKind walls, unsigned wanted, const GoOn& go_on) {
  const std::size_t all = delaunay.simplices.size();
  meshops::require_one_each("periodic_topology", radii.size(), "radii", all, "tetrahedra");
  meshops::require(
      delaunay.neighbors.size() == all,
      "periodic_topology: the triangulation has no neighbors, expected periodic_solid() with the option neighbors");
  for (const auto& row : delaunay.neighbors)
    for (const std::uint32_t n : row)
      meshops::require(n < all,
                       "periodic_topology: expected tetrahedra that fill the box, from periodic_solid() at infinity");
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");

  Threads threads = threads_for(delaunay.distinct, wanted);
  Complex of{delaunay, std::vector<bool>(all)};
  for (std::size_t t = 0; t < all; ++t) of.is_inside[t] = radii[t] <= alpha;
  if (walls == ComplexKind::full) of.faces.emplace(space::Triangulated(delaunay), radii, alpha, threads, go_on);
  PeriodicTopology topology;
  count_simplices(of, threads, go_on, topology);

  const auto is_bounding = [&](std::uint32_t t, std::size_t k) { return of.is_bounding(t, k); };
  const space::Parts parts(
      all,
      [&](std::uint32_t t, std::size_t k) {
        return space::TetrahedronImage{delaunay.neighbors[t][k], step_across(delaunay, t, k)};
      },
      [&](std::uint32_t t, std::size_t k) { return !of.is_bounding(t, k); },
      [&](std::uint32_t t) { return !of.is_inside[t]; });
  Hull hull(delaunay);
  std::vector<std::uint32_t> tetrahedra;  // all tetrahedra inside the complex
  for (std::uint32_t t = 0; t < all; ++t)
    if (of.is_inside[t]) tetrahedra.push_back(t);
  hull.enclose(tetrahedra, is_bounding);
  const space::ClosedMeasures whole = hull.measures();
  topology.volume = whole.volume;
  topology.area = whole.area;

  std::vector<double> outside;
  if (of.faces) outside = outside_of_balls(of, parts, alpha, threads, go_on);
  std::vector<space::ClosedMeasures> measures;
  std::vector<PeriodicPart> found;
  Steps step(go_on);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    step(parts.tetrahedra(i).size());
    hull.enclose(parts.tetrahedra(i), is_bounding);
    measures.push_back(hull.measures());
    PeriodicPart& part = found.emplace_back();
    part.tetrahedra = parts.tetrahedra(i).size();
    part.points = points_of(delaunay, hull.bounding());
    part.volume = measures.back().volume;
    part.area = measures.back().area;
    part.dimension = parts.directions(i).value();
    if (of.faces && !of.is_inside[parts.tetrahedra(i).front()]) part.outside_balls = outside[i];
  }
  for (const std::uint32_t i : space::by_volume(measures))
    (of.is_inside[parts.tetrahedra(i).front()] ? topology.solid_components : topology.voids)
        .push_back(std::move(found[i]));
  find_betti(parts, topology);
  return topology;
}

}  // namespace rbpa
