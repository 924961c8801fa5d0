#include "rbpa/solid_filtration.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "rbpa/base/parallel/in_order.h"
#include "rbpa/base/simplices_at.h"
#include "rbpa/solid_radii.h"
#include "rbpa/space/full/check_triangulation.h"
#include "rbpa/space/full/faces_within.h"
#include "rbpa/space/predicate/least_sphere.h"

namespace rbpa {
namespace {

constexpr std::uint32_t none = Solid::none;
constexpr std::size_t at_a_time = 1u << 12;

/// Numbers the triangles, by the first tetrahedron of each.
void list_triangles(const Solid& delaunay, SolidFiltration& filtration) {
  filtration.triangles_of.resize(delaunay.simplices.size());
  for (std::uint32_t t = 0; t < delaunay.simplices.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t beyond = delaunay.neighbors[t][k];
      if (beyond < t) {
        const auto& others = delaunay.neighbors[beyond];
        const auto back = static_cast<std::size_t>(std::find(others.begin(), others.end(), t) - others.begin());
        filtration.triangles_of[t][k] = filtration.triangles_of[beyond][back];
        continue;
      }
      filtration.triangles_of[t][k] = static_cast<std::uint32_t>(filtration.triangles.size());
      Triangle triangle = {delaunay.simplices[t][(k + 1) % 4], delaunay.simplices[t][(k + 2) % 4],
                           delaunay.simplices[t][(k + 3) % 4]};
      std::sort(triangle.begin(), triangle.end());
      filtration.triangles.push_back(triangle);
    }
}

/// That of its own least sphere if no corner across is inside, else that of the first tetrahedron at it.
double alpha_of_triangle(std::span<const Point3> points, const Solid& delaunay, const SolidFiltration& filtration,
                         std::uint32_t t, std::size_t k) {
  const Triangle& triangle = filtration.triangles[filtration.triangles_of[t][k]];
  const Point3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  double least = filtration.tetrahedron_alpha[t];
  bool is_alone = !space::in_least_sphere(a, b, c, points[delaunay.simplices[t][k]]);
  if (const std::uint32_t beyond = delaunay.neighbors[t][k]; beyond != none) {
    least = std::min(least, filtration.tetrahedron_alpha[beyond]);
    for (const std::uint32_t corner : delaunay.simplices[beyond])
      if (corner != triangle[0] && corner != triangle[1] && corner != triangle[2])
        is_alone = is_alone && !space::in_least_sphere(a, b, c, points[corner]);
  }
  return is_alone ? space::least_radius_rounded_up(a, b, c) : least;
}

void find_alpha_of_triangles(std::span<const Point3> points, const Solid& delaunay, Threads& threads,
                             SolidFiltration& filtration) {
  filtration.triangle_alpha.resize(filtration.triangles.size());
  for_each_part(threads, delaunay.simplices.size(), at_a_time, [&](std::size_t begin, std::size_t end) {
    for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t beyond = delaunay.neighbors[t][k];
        if (beyond == none || t < beyond)
          filtration.triangle_alpha[filtration.triangles_of[t][k]] =
              alpha_of_triangle(points, delaunay, filtration, t, k);
      }
  });
}

/// That of its own least sphere if no corner around is inside, else that of the first triangle at it.
double alpha_of_edge(std::span<const Point3> points, const Solid& delaunay, const SolidFiltration& filtration,
                     std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> around) {
  double least = std::numeric_limits<double>::infinity();
  bool is_alone = true;
  for (const std::uint32_t t : around)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t corner = delaunay.simplices[t][k];
      if (corner == a || corner == b) continue;
      least = std::min(least, filtration.triangle_alpha[filtration.triangles_of[t][k]]);
      is_alone = is_alone && !space::in_least_sphere(points[a], points[b], points[corner]);
    }
  return is_alone ? space::least_radius_rounded_up(points[a], points[b]) : least;
}

void list_edges(std::span<const Point3> points, const Solid& delaunay, Threads& threads, SolidFiltration& filtration) {
  constexpr std::size_t points_at_a_time = 1u << 10;
  const std::size_t bound = corner_bound<4>(delaunay.simplices);
  const TetrahedraAt stars(delaunay.simplices, bound);
  struct Workspace {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::vector<double> alpha;
  };
  in_order<Workspace>(
      threads, (bound + points_at_a_time - 1) / points_at_a_time,
      [&](std::size_t part, Workspace& w) {
        w.edges.clear();
        w.alpha.clear();
        const std::size_t end = std::min((part + 1) * points_at_a_time, bound);
        for (auto a = static_cast<std::uint32_t>(part * points_at_a_time); a < end; ++a)
          space::for_each_edge_up(a, stars[a], delaunay, w.ends,
                                  [&](std::uint32_t b, std::span<const std::uint32_t> around) {
                                    w.edges.push_back({a, b});
                                    w.alpha.push_back(alpha_of_edge(points, delaunay, filtration, a, b, around));
                                  });
      },
      [&](std::size_t, Workspace& w) {
        filtration.edges.insert(filtration.edges.end(), w.edges.begin(), w.edges.end());
        filtration.edge_alpha.insert(filtration.edge_alpha.end(), w.alpha.begin(), w.alpha.end());
      },
      [](std::size_t, Workspace&) {});
}

}  // namespace

SolidFiltration solid_filtration(std::span<const Point3> points, const Solid& delaunay, unsigned wanted) {
  SolidFiltration filtration;
  filtration.tetrahedron_alpha = circumradii(points, delaunay.simplices, wanted);
  Threads threads =
      space::check_triangulation("solid_filtration", points, delaunay, filtration.tetrahedron_alpha, 1, wanted);
  list_triangles(delaunay, filtration);
  find_alpha_of_triangles(points, delaunay, threads, filtration);
  list_edges(points, delaunay, threads, filtration);
  return filtration;
}

}  // namespace rbpa
