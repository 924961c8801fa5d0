#include "rbpa/space/persistence/pairing/triangle_radii.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/space/predicate/least_sphere.h"

namespace rbpa::space {
namespace {

double radius(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
              const Triangle& triangle, std::uint32_t t, std::size_t k) {
  const auto& [simplices, neighbors, duplicates, isolated, distinct] = delaunay;
  const LeastSphere sphere(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
  double least = radii[t];
  bool is_alone = !sphere.has_inside(points[simplices[t][k]]);
  if (const std::uint32_t beyond = neighbors[t][k]; beyond != Solid::none) {
    least = std::min(least, radii[beyond]);
    const auto back = static_cast<std::size_t>(std::find(neighbors[beyond].begin(), neighbors[beyond].end(), t) -
                                               neighbors[beyond].begin());
    is_alone = is_alone && !sphere.has_inside(points[simplices[beyond][back]]);
  }
  return is_alone ? sphere.radius_rounded_up() : least;
}

}  // namespace

std::vector<double> triangle_radii(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                                   const NumberedTriangles& triangles, Threads& threads, const GoOn& go_on) {
  constexpr std::size_t at_a_time = 1u << 12;
  std::vector<double> result(triangles.corners.size());
  CheckpointOfThreads checkpoint(go_on);
  for_each_part(threads, triangles.of.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    checkpoint();
    for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
      for (std::size_t k = 0; k < 4; ++k)
        if (delaunay.neighbors[t][k] == Solid::none || t < delaunay.neighbors[t][k]) {
          const std::uint32_t number = triangles.of[t][k];
          result[number] = radius(points, delaunay, radii, triangles.corners[number], t, k);
        }
  });
  return result;
}

}  // namespace rbpa::space
