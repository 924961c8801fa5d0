#include "rbpa/periodic_topology.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/simplices_at.h"
#include "rbpa/space/boundary/by_volume.h"
#include "rbpa/space/boundary/measures.h"
#include "rbpa/space/outer_faces.h"
#include "rbpa/space/periodic/parts.h"

namespace rbpa {
namespace {

using space::Boxes;
constexpr Boxes nowhere = {0, 0, 0};

Triangle outer_face(const PeriodicSolid& solid, std::uint32_t t, std::size_t k) {
  return space::outer_face(solid.simplices[t], k);
}

Point3 minus(const Point3& p, const std::array<std::int8_t, 3>& offset, const Point3& box) {
  return {p.x - offset[0] * box.x, p.y - offset[1] * box.y, p.z - offset[2] * box.z};
}

/// The image whose least corner is in the box, from that corner on: of all images the same.
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

/// What closes some of the tetrahedra where they are: first the triangles that bound them, then those between two of them that are an image away.
class Hull {
 public:
  explicit Hull(const PeriodicSolid& solid) : solid_(solid), measure_(solid.positions) {}

  /// Replaces what was there.
  void enclose(std::span<const std::uint32_t> tetrahedra, const std::vector<bool>& is_inside) {
    triangles_.clear();
    for (const std::uint32_t t : tetrahedra)
      for (std::size_t k = 0; k < 4; ++k)
        if (is_inside[solid_.neighbors[t][k]] != is_inside[t]) triangles_.push_back(outer_face(solid_, t, k));
    bounding_ = triangles_.size();
    for (const std::uint32_t t : tetrahedra)
      for (std::size_t k = 0; k < 4; ++k)
        if (is_inside[solid_.neighbors[t][k]] == is_inside[t] && space::step_across(solid_, t, k) != nowhere)
          triangles_.push_back(outer_face(solid_, t, k));
  }

  std::span<const Triangle> bounding() const { return std::span(triangles_).first(bounding_); }

  /// Of the volume within, the area of the bounding triangles, and the least of these.
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
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  points.shrink_to_fit();
  return points;
}

/// Edges of the tetrahedra inside. One is known by its points, and how many boxes these are apart.
std::size_t count_edges(const PeriodicSolid& inside) {
  const Solid by_points = without_offsets(inside);
  const std::size_t bound = corner_bound<4>(by_points.simplices);
  const TetrahedraAt stars(by_points.simplices, bound);
  std::size_t count = 0;
  std::vector<std::pair<std::uint32_t, std::array<int, 3>>> ends;
  for (std::uint32_t a = 0; a < bound; ++a) {
    ends.clear();
    for (const std::uint32_t t : stars[a]) {
      const auto& points = by_points.simplices[t];
      const auto at = static_cast<std::size_t>(std::find(points.begin(), points.end(), a) - points.begin());
      const auto& from = inside.vertices[inside.simplices[t][at]].offset;
      for (std::size_t k = 0; k < 4; ++k) {
        if (points[k] <= a) continue;
        const auto& to = inside.vertices[inside.simplices[t][k]].offset;
        ends.push_back({points[k], {to[0] - from[0], to[1] - from[1], to[2] - from[2]}});
      }
    }
    std::sort(ends.begin(), ends.end());
    count += static_cast<std::size_t>(std::unique(ends.begin(), ends.end()) - ends.begin());
  }
  return count;
}

/// Points that are corners, and how many pieces they are connected to by tetrahedra.
std::pair<std::size_t, std::size_t> count_points(const PeriodicSolid& inside) {
  const Solid by_points = without_offsets(inside);
  meshops::DisjointSets sets(corner_bound<4>(by_points.simplices));
  std::vector<bool> is_corner(sets.size(), false);
  std::size_t points = 0, joined = 0;
  for (const auto& row : by_points.simplices)
    for (const std::uint32_t corner : row) {
      points += is_corner[corner] ? 0u : 1u;
      is_corner[corner] = true;
      joined += sets.join(row[0], corner) ? 1u : 0u;
    }
  return {points, points - joined};
}

/// Betti numbers of what is inside. By duality b₂ is that of one-dimensional cohomology of the torus relative to the outside: a class for each
/// void but one, and for each direction of the torus in which no void goes on.
void find_betti(const space::Parts& parts, PeriodicTopology& topology) {
  auto& [b0, b1, b2, b3] = topology.betti;
  if (topology.tetrahedra == 0) return;
  b3 = topology.voids.empty() ? 1 : 0;
  b2 = topology.voids.empty() ? 3 : topology.voids.size() + 2 - parts.directions_outside().value();
  b1 = b0 + b2 + topology.edges + topology.tetrahedra - b3 - topology.points - topology.triangles;
}

}  // namespace

PeriodicTopology periodic_topology(const PeriodicSolid& delaunay, std::span<const double> radii, double alpha) {
  const std::size_t all = delaunay.simplices.size();
  meshops::require(radii.size() == all, "periodic_topology: expected a radius for each tetrahedron");
  meshops::require(delaunay.neighbors.size() == all, "periodic_topology: the triangulation has no neighbors");
  for (const auto& row : delaunay.neighbors)
    for (const std::uint32_t n : row)
      meshops::require(n < all,
                       "periodic_topology: expected tetrahedra that fill the box, from periodic_solid() at infinity");

  PeriodicTopology topology;
  const PeriodicSolid inside = within(delaunay, radii, alpha);
  topology.tetrahedra = inside.simplices.size();
  for (const auto& row : inside.neighbors)
    for (const std::uint32_t n : row) topology.boundary_triangles += n == Solid::none ? 1u : 0u;
  topology.triangles = (4 * topology.tetrahedra + topology.boundary_triangles) / 2;
  topology.edges = count_edges(inside);
  std::tie(topology.points, topology.betti[0]) = count_points(inside);

  std::vector<bool> is_inside(all);
  for (std::size_t t = 0; t < all; ++t) is_inside[t] = radii[t] <= alpha;
  const space::Parts parts(delaunay, is_inside);
  Hull hull(delaunay);
  std::vector<std::uint32_t> tetrahedra;  // all inside
  for (std::uint32_t t = 0; t < all; ++t)
    if (is_inside[t]) tetrahedra.push_back(t);
  hull.enclose(tetrahedra, is_inside);
  const space::ClosedMeasures whole = hull.measures();
  topology.volume = whole.volume;
  topology.area = whole.area;

  std::vector<space::ClosedMeasures> measures;
  std::vector<PeriodicPart> found;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    hull.enclose(parts.tetrahedra(i), is_inside);
    measures.push_back(hull.measures());
    found.push_back({.tetrahedra = parts.tetrahedra(i).size(),
                     .points = points_of(delaunay, hull.bounding()),
                     .volume = measures.back().volume,
                     .area = measures.back().area,
                     .dimension = parts.directions(i).value()});
  }
  for (const std::uint32_t i : space::by_volume(measures))
    (is_inside[parts.tetrahedra(i).front()] ? topology.solid_components : topology.voids)
        .push_back(std::move(found[i]));
  find_betti(parts, topology);
  return topology;
}

}  // namespace rbpa
