#include "rbpa/space/surface.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "rbpa/core/error.h"
#include "rbpa/space/check_input.h"
#include "rbpa/space/pivot/find_free_arcs.h"
#include "rbpa/space/predicate/normal_sign.h"

namespace rbpa {
namespace {

using space::FreeArc;
using Triangle = std::array<std::uint32_t, 3>;

/// The input indices, equal points together, the lowest of them first.
std::vector<std::uint32_t> sorted_by_point(std::span<const Point3> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return points[i] != points[j] ? points[i] < points[j] : i < j; });
  return order;
}

/// The distinct points, in lexicographic order.
struct Sites {
  std::vector<Point3> points;
  std::vector<std::uint32_t> input;  // the lowest index at each
  std::vector<std::size_t> first;    // in `order`, of each; and the end
  std::vector<std::uint32_t> order;  // of all input points
};

Sites sites_of(std::span<const Point3> points, Surface& surface) {
  Sites sites;
  sites.order = sorted_by_point(points);
  for (std::size_t i = 0; i < sites.order.size(); ++i) {
    const std::uint32_t index = sites.order[i];
    if (i > 0 && points[index] == sites.points.back()) {
      surface.duplicates.push_back({index, sites.input.back()});
      continue;
    }
    sites.points.push_back(points[index]);
    sites.input.push_back(index);
    sites.first.push_back(i);
  }
  sites.first.push_back(sites.order.size());
  surface.distinct = sites.points.size();
  std::sort(surface.duplicates.begin(), surface.duplicates.end(),
            [](const Duplicate& d, const Duplicate& e) { return d.index < e.index; });
  return sites;
}

Triangle from_least(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a < b && a < c) return {a, b, c};
  return b < c ? Triangle{b, c, a} : Triangle{c, a, b};
}

std::vector<FreeArc> arcs_of(const Sites& sites, double radius, const SurfaceOptions& options) {
  Threads threads(sites.points.size() < 1000 ? 1 : options.threads);  // few are done before another thread has woken
  std::function<void(std::size_t)> found;
  if (options.progress)
    found = [&](std::size_t arcs) {
      // Three arcs for two triangles.
      if (!options.progress({arcs / 3 * 2, sites.points.size()})) throw Cancelled();
    };
  return space::find_free_arcs(sites.points, radius, threads, found);
}

/// Calls visit(triangle, corner) for both triangles of an arc, by input indices; the arc is on the side across from the corner.
template <typename Visit>
void for_both(const FreeArc& arc, const Sites& sites, Visit visit) {
  const auto& in = sites.input;
  visit(from_least(in[arc.a], in[arc.b], in[arc.left]), in[arc.left]);
  visit(from_least(in[arc.b], in[arc.a], in[arc.touched]), in[arc.touched]);
}

/// All triangles of the arcs for which keep(a, b, c), of sites, and how they are glued.
template <typename Keep>
void assemble(const std::vector<FreeArc>& arcs, const Sites& sites, Keep keep, Surface& surface) {
  auto& triangles = surface.triangles;
  // A triangle has an arc at each of its sides: taken at the one across from its greatest site, it comes once.
  const auto take = [&](space::Site a, space::Site b, space::Site c) {
    if (c > a && c > b && keep(a, b, c))
      triangles.push_back(from_least(sites.input[a], sites.input[b], sites.input[c]));
  };
  for (const FreeArc& arc : arcs) {
    take(arc.a, arc.b, arc.left);
    take(arc.b, arc.a, arc.touched);
  }
  std::sort(triangles.begin(), triangles.end());

  surface.neighbors.assign(triangles.size(), {Surface::none, Surface::none, Surface::none});
  for (const FreeArc& arc : arcs) {
    std::array<std::size_t, 2> at, side;
    std::size_t count = 0;
    for_both(arc, sites, [&](const Triangle& triangle, std::uint32_t corner) {
      const auto found = std::lower_bound(triangles.begin(), triangles.end(), triangle);
      if (found == triangles.end() || *found != triangle) return;
      at[count] = static_cast<std::size_t>(found - triangles.begin());
      side[count++] = static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), corner) - triangle.begin());
    });
    if (count < 2) continue;
    surface.neighbors[at[0]][side[0]] = static_cast<std::uint32_t>(at[1]);
    surface.neighbors[at[1]][side[1]] = static_cast<std::uint32_t>(at[0]);
  }
}

}  // namespace

Surface exposed_triangles(std::span<const Point3> points, double radius, const SurfaceOptions& options) {
  space::check_radius(radius);
  space::check_points(points);
  Surface surface;
  const Sites sites = sites_of(points, surface);
  assemble(
      arcs_of(sites, radius, options), sites, [](auto, auto, auto) { return true; }, surface);
  return surface;
}

Surface surface(std::span<const Point3> points, std::span<const Point3> normals, double radius,
                const SurfaceOptions& options) {
  space::check_radius(radius);
  space::check_points(points);
  space::check_normals(points, normals);
  Surface surface;
  const Sites sites = sites_of(points, surface);
  const auto agrees = [&](space::Site a, space::Site b, space::Site c) {
    const space::TriangleNormal normal(sites.points[a], sites.points[b], sites.points[c]);
    for (const space::Site corner : {a, b, c})
      for (std::size_t i = sites.first[corner]; i < sites.first[corner + 1]; ++i)
        if (normal.sign_along(normals[sites.order[i]]) <= 0) return false;
    return true;
  };
  assemble(arcs_of(sites, radius, options), sites, agrees, surface);
  return surface;
}

}  // namespace rbpa
