#include "rbpa/space/balls/full/faces_within.h"

#include "rbpa/space/predicate/least_sphere.h"
#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa::space {

bool is_edge_alone(const Triangulated& delaunay, std::span<const EdgeAt> ring, double alpha) {
  const auto end = [&](const EdgeAt& at, std::size_t k) -> const Point3& {
    return delaunay.position(at.tetrahedron, k);
  };
  if (!is_least_sphere_within(end(ring[0], ring[0].from), end(ring[0], ring[0].to), alpha)) return false;
  return std::none_of(ring.begin(), ring.end(), [&](const EdgeAt& at) {
    const auto [k, l] = others(at);
    const Point3 &a = end(at, at.from), &b = end(at, at.to);
    return in_least_sphere(a, b, end(at, k)) || in_least_sphere(a, b, end(at, l));
  });
}

FacesWithin::FacesWithin(const Triangulated& delaunay, std::span<const double> radii, double alpha, Threads& threads,
                         const GoOn& go_on)
    : delaunay_(delaunay), radii_(radii), alpha_(alpha), has_triangle_(4 * radii.size()) {
  constexpr std::size_t at_a_time = 1u << 12;
  const auto& neighbors = delaunay_.neighbors;
  // Returns the corner of the tetrahedron beyond corner k's face that is across from t.
  const auto back = [&](std::uint32_t t, std::size_t k) {
    const auto& others = neighbors[neighbors[t][k]];
    return static_cast<std::size_t>(std::find(others.begin(), others.end(), t) - others.begin());
  };
  const auto is_empty_beside = [&](std::uint32_t t, std::size_t k) {
    const auto face = [&](std::size_t i) -> const Point3& { return delaunay_.position(t, outer_faces[k][i]); };
    const LeastSphere sphere(face(0), face(1), face(2));
    return sphere.is_within(alpha_) && !sphere.has_inside(delaunay_.position(t, k));
  };
  const auto is_alone_within = [&](std::uint32_t t, std::size_t k) {
    return is_empty_beside(t, k) && (is_on_hull(t, k) || is_empty_beside(neighbors[t][k], back(t, k)));
  };
  // Each triangle is decided at its first tetrahedron; the second copies the result.
  CheckpointOfThreads checkpoint(go_on);
  for_each_part(threads, radii_.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    checkpoint();
    for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
      for (std::size_t k = 0; k < 4; ++k)
        if (is_first(t, k)) has_triangle_[4 * std::size_t{t} + k] = tetrahedra_at(t, k) > 0 || is_alone_within(t, k);
  });
  for_each_part(threads, radii_.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    checkpoint();
    for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
      for (std::size_t k = 0; k < 4; ++k)
        if (!is_first(t, k))
          has_triangle_[4 * std::size_t{t} + k] = has_triangle_[4 * std::size_t{neighbors[t][k]} + back(t, k)];
  });
}

}  // namespace rbpa::space
