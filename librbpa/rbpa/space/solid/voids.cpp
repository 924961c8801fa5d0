#include "rbpa/space/solid/voids.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "rbpa/base/arrays/grouped.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/solid/boundary/connected.h"
#include "rbpa/space/solid/boundary/measures.h"
#include "rbpa/space/solid/boundary/outside.h"

namespace rbpa {
namespace {

/// Returns 1 if the ray from within tetrahedron `from` crosses the triangle from behind, −1 from the front, else 0.
/// Exact: the ray, along x, begins at the first corner, moved into the tetrahedron by infinitesimals: it thus passes
/// through no point, and through no edge except one along the ray. Requires: the tetrahedron is not flat.
int ray_crossing(const std::array<Point3, 3>& triangle, const std::array<Point3, 4>& from) {
  const auto& [a, b, c] = triangle;
  const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
  if (from[0].y < low_y || from[0].y > high_y) return 0;
  const auto [low_z, high_z] = std::minmax({a.z, b.z, c.z});
  if (from[0].z < low_z || from[0].z > high_z) return 0;
  // The ray begins at p + ε q + ε² r + ε³ s for corners p, q, r, s: the first corner that is not on the line decides.
  const auto side_of_line = [&](const Point3& u, const Point3& v) {
    for (const Point3& p : from)
      if (const int side = space::orientation_along(u, v, p, 0); side != 0) return side;
    return 0;
  };
  const int first = side_of_line(a, b);
  if (first == 0 || side_of_line(b, c) != first || side_of_line(c, a) != first) return 0;
  // The triangle is ahead of the ray if the beginning is on the side of the plane from which the ray comes.
  for (const Point3& p : from)
    if (const int side = space::orientation(a, b, c, p); side != 0) return side == -first ? first : 0;
  return 0;
}

/// The nesting of the boundary's surfaces, which determines the void that each surface bounds:
///   1. find the surface around each component of the complex; the component's other surfaces are around voids;
///   2. find the components within each surface around a void;
///   3. find the innermost void around each component.
class Nesting {
 public:
  Nesting(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary, space::Outside& outside)
      : points_(points),
        solid_(solid),
        boundary_(boundary),
        surfaces_(boundary.tetrahedra.size(), boundary.tetrahedra.size(),
                  [&](std::uint32_t t) { return outside.surfaces.find(t); }),
        component_(surfaces_.size()),
        around_(surfaces_.size(), Voids::none) {
    const space::Grouped components(surfaces_.size(), solid.simplices.size(), [&](std::uint32_t s) {
      return outside.components.find(boundary.tetrahedra[surfaces_.items(s).front()]);
    });
    component_ = components.number();
    outer_.resize(components.size());
    for (std::uint32_t c = 0; c < outer_.size(); ++c) outer_[c] = outer_surface(components.items(c));
  }

  const space::Grouped& surfaces() const { return surfaces_; }
  /// Returns whether a surface is around a component.
  bool is_outer(std::uint32_t surface) const { return outer_[component_[surface]] == surface; }
  /// Returns for a surface around a component the surface around the innermost void that contains it, or none.
  std::uint32_t around(std::uint32_t surface) const { return around_[surface]; }

  /// Does steps 2 and 3.
  void find_floating() {
    std::vector<std::uint32_t> by_y(outer_.size());
    std::iota(by_y.begin(), by_y.end(), std::uint32_t{0});
    std::sort(by_y.begin(), by_y.end(),
              [&](std::uint32_t c, std::uint32_t d) { return start(c)[0].y < start(d)[0].y; });
    std::vector<std::uint32_t> depth(outer_.size(), 0);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> within;  // a component; a surface around it and a void
    for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
      if (is_outer(s)) continue;
      for (const std::uint32_t c : components_within(s, by_y)) {
        within.emplace_back(c, s);
        ++depth[c];
      }
    }
    // The innermost void around c is bounded by the component that lies in one void fewer than c.
    for (const auto& [c, s] : within)
      if (depth[component_[s]] + 1 == depth[c]) around_[outer_[c]] = s;
  }

 private:
  using Tetrahedron = std::array<Point3, 4>;

  std::array<Point3, 3> corners(std::uint32_t triangle) const {
    const auto& [a, b, c] = boundary_.surface.triangles[triangle];
    return {points_[a], points_[b], points_[c]};
  }
  /// Returns a tetrahedron of a component, within which rays start.
  Tetrahedron start(std::uint32_t component) const {
    const auto& [a, b, c, d] = solid_.simplices[boundary_.tetrahedra[surfaces_.items(outer_[component]).front()]];
    return {points_[a], points_[b], points_[c], points_[d]};
  }

  /// Returns the element of `surfaces` that encloses the component. Requires: all surfaces of one component.
  std::uint32_t outer_surface(std::span<const std::uint32_t> surfaces) const {
    const auto& [a, b, c, d] = solid_.simplices[boundary_.tetrahedra[surfaces_.items(surfaces.front()).front()]];
    const Tetrahedron from = {points_[a], points_[b], points_[c], points_[d]};
    for (std::size_t i = 0; i + 1 < surfaces.size(); ++i)
      if (winding(surfaces_.items(surfaces[i]), from) != 0) return surfaces[i];
    return surfaces.back();
  }
  int winding(std::span<const std::uint32_t> triangles, const Tetrahedron& from) const {
    int turns = 0;
    for (const std::uint32_t t : triangles) turns += ray_crossing(corners(t), from);
    return turns;
  }

  /// Returns the other components inside `surface`, which is around a void. `by_y` has all components, sorted by the y
  /// of start()[0]. A component is tested only if its start()[0] is in the bounding box of the surface.
  std::vector<std::uint32_t> components_within(std::uint32_t surface, const std::vector<std::uint32_t>& by_y) const {
    const auto triangles = surfaces_.items(surface);
    space::Box box;
    for (const std::uint32_t t : triangles) box.include(space::box_of(corners(t)));
    const Point3 &low = box.low, &high = box.high;
    const auto first_from = [&](const std::vector<std::uint32_t>& components, double y) {
      return std::lower_bound(components.begin(), components.end(), y,
                              [&](std::uint32_t c, double value) { return start(c)[0].y < value; });
    };
    std::vector<std::uint32_t> inside_box;  // the components with start()[0] in the box, sorted by y
    for (auto c = first_from(by_y, low.y); c != by_y.end() && start(*c)[0].y <= high.y; ++c) {
      const Point3 p = start(*c)[0];
      if (*c != component_[surface] && p.x >= low.x && p.x <= high.x && p.z >= low.z && p.z <= high.z)
        inside_box.push_back(*c);
    }
    std::vector<int> turns(inside_box.size(), 0);
    if (!inside_box.empty())
      for (const std::uint32_t t : triangles) {
        const auto triangle = corners(t);
        const auto [low_y, high_y] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
        for (auto c = first_from(inside_box, low_y); c != inside_box.end() && start(*c)[0].y <= high_y; ++c)
          turns[static_cast<std::size_t>(c - inside_box.begin())] += ray_crossing(triangle, start(*c));
      }
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < inside_box.size(); ++i)
      if (turns[i] != 0) result.push_back(inside_box[i]);
    return result;
  }

  std::span<const Point3> points_;
  const Solid& solid_;
  const SolidBoundary& boundary_;
  space::Grouped surfaces_;
  std::vector<std::uint32_t> component_;  // for each surface: the component that it bounds
  std::vector<std::uint32_t> outer_;      // for each component: the surface around it
  std::vector<std::uint32_t> around_;
};

std::vector<std::uint32_t> corners_of(const SolidBoundary& boundary, std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> points;
  points.reserve(3 * triangles.size());
  for (const std::uint32_t t : triangles)
    points.insert(points.end(), boundary.surface.triangles[t].begin(), boundary.surface.triangles[t].end());
  sort_unique(points);
  points.shrink_to_fit();
  return points;
}

}  // namespace

Voids voids(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary) {
  space::Outside outside = space::outside_of(points, solid, boundary);
  Voids result;
  result.counts = space::count_solid(solid, boundary, outside);
  result.number.assign(boundary.tetrahedra.size(), Voids::none);
  if (result.counts.voids == 0) return result;

  Nesting nesting(points, solid, boundary, outside);
  nesting.find_floating();
  // The number of a void is for now that of the surface around the void.
  const auto& surfaces = nesting.surfaces();
  std::vector<std::size_t> islands(surfaces.size(), 0);
  for (std::uint32_t s = 0; s < surfaces.size(); ++s)
    if (nesting.is_outer(s) && nesting.around(s) != Voids::none) ++islands[nesting.around(s)];
  const space::Grouped of_voids(boundary.tetrahedra.size(), surfaces.size(), [&](std::uint32_t t) {
    const std::uint32_t s = surfaces.number()[t];
    return nesting.is_outer(s) ? nesting.around(s) : s;
  });
  const space::Measures measure(points);
  std::vector<space::ClosedMeasures> measures;
  std::vector<std::uint32_t> key;
  for (std::size_t v = 0; v < of_voids.size(); ++v) {
    measures.push_back(measure.of(boundary.surface.triangles, of_voids.items(v)));
    const std::uint32_t s = surfaces.number()[of_voids.items(v).front()];
    key.push_back(nesting.is_outer(s) ? nesting.around(s) : s);
  }
  std::vector<std::uint32_t> place(of_voids.size());
  for (const std::uint32_t v : space::by_volume(measures)) {
    place[v] = static_cast<std::uint32_t>(result.all.size());
    const auto triangles = of_voids.items(v);
    const space::ClosedMeasures& of = measures[v];
    // The triangles face the void, so that their signed volume is negative.
    result.all.push_back({{triangles.begin(), triangles.end()},
                          corners_of(boundary, triangles),
                          islands[key[v]],
                          -of.volume,
                          {},
                          of.area,
                          of.low,
                          of.high});
  }
  for (std::size_t t = 0; t < result.number.size(); ++t)
    if (of_voids.number()[t] != Voids::none) result.number[t] = place[of_voids.number()[t]];
  return result;
}

}  // namespace rbpa
