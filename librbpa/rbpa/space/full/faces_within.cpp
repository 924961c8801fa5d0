#include "rbpa/space/full/faces_within.h"

#include <algorithm>
#include <cmath>

#include "rbpa/space/outer_faces.h"
#include "rbpa/space/predicate/least_sphere.h"

namespace rbpa::space {

FacesWithin::FacesWithin(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                         double alpha, Threads& threads, const std::function<bool()>& go_on)
    : points_(points), delaunay_(delaunay), radii_(radii), alpha_(alpha), has_triangle_(4 * radii.size()) {
  constexpr std::size_t at_a_time = 1u << 12;
  const auto is_alone_within = [&](std::uint32_t t, std::size_t k) {
    const auto& corners = delaunay_.simplices[t];
    const LeastSphere sphere(points_[corners[outer_faces[k][0]]], points_[corners[outer_faces[k][1]]],
                             points_[corners[outer_faces[k][2]]]);
    if (!sphere.is_within(alpha_) || sphere.has_inside(points_[corners[k]])) return false;
    const std::uint32_t beyond = delaunay_.neighbors[t][k];
    if (beyond == Solid::none) return true;
    return !sphere.has_inside(points_[delaunay_.simplices[beyond][back(t, k)]]);
  };
  // Each by its first tetrahedron, and then read from there.
  AskFromAnyThread ask(go_on);
  for_each_part(threads, radii_.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    ask();
    for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
      for (std::size_t k = 0; k < 4; ++k)
        if (is_first(t, k)) has_triangle_[4 * std::size_t{t} + k] = tetrahedra_at(t, k) > 0 || is_alone_within(t, k);
  });
  for_each_part(threads, radii_.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    ask();
    for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
      for (std::size_t k = 0; k < 4; ++k) {
        if (is_first(t, k)) continue;
        const std::uint32_t first = delaunay_.neighbors[t][k];
        has_triangle_[4 * std::size_t{t} + k] = has_triangle_[4 * std::size_t{first} + back(t, k)];
      }
  });
}

bool FacesWithin::has_triangle_at(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> around) const {
  for (const std::uint32_t t : around)
    for (std::size_t k = 0; k < 4; ++k)
      if (const std::uint32_t corner = delaunay_.simplices[t][k]; corner != a && corner != b && has_triangle(t, k))
        return true;
  return false;
}

bool FacesWithin::has_edge_alone(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> around) const {
  if (!is_least_sphere_within(points_[a], points_[b], alpha_)) return false;
  for (const std::uint32_t t : around)
    for (const std::uint32_t corner : delaunay_.simplices[t])
      if (corner != a && corner != b && in_least_sphere(points_[a], points_[b], points_[corner])) return false;
  return true;
}

}  // namespace rbpa::space
