#include "rbpa/space/surface/unused_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "meshops/core/contract.h"
#include "rbpa/base/arrays/distinct.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/cells/cells.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/agreement.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/resting_ball.h"
#include "rbpa/space/surface/levels/neighborhood_subset.h"
#include "rbpa/space/surface/levels/sub_surface.h"
#include "rbpa/space/surface/star/exposed_at.h"

namespace rbpa {
namespace {

/// Returns the distinct points that are in no triangle, each with the first cause.
std::vector<UnusedPoint> without_triangle(std::size_t points, const Surface& surface) {
  std::vector<std::uint8_t> is_used(points, 0);
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t corner : triangle) {
      meshops::require(corner < points, "unused_points: a triangle has a corner that is not a point");
      is_used[corner] = 1;
    }
  std::vector<UnusedPoint> unused;
  for_each_distinct(points, surface.duplicates, [&](std::uint32_t i) {
    if (is_used[i] == 0) unused.push_back({i, UnusedCause::no_ball_rests});
  });
  return unused;
}

/// Raises the causes of points on `exposed`, the exposed triangles of one radius near unused points.
void raise_causes(const space::NeighborhoodSubset& near, std::span<const space::ExposedAt> exposed,
                  const space::Agreement& agreement, std::vector<UnusedCause>& causes, Steps& step) {
  for (const space::ExposedAt& local : exposed) {
    step(2);
    const std::array triangle = {near.input[local.at], near.input[local.second], near.input[local.third]};
    const bool agrees = agreement(triangle[0], triangle[1], triangle[2]);
    for (const std::uint32_t i : triangle)
      causes[i] = std::max(causes[i], agrees ? UnusedCause::blocked : UnusedCause::normals_disagree);
  }
}

/// Returns whether every ball that touches points[v] contains another point. This is so exactly if a ball rests on v,
/// the nearest point and a third one (docs/explanation/surfaces.md, section 18). Requires: distinct points; no empty
/// ball rests on v; `around` has all points that such balls can touch or hold.
bool is_hidden(std::uint32_t v, std::span<const Point3> points, std::span<const std::uint32_t> around, double radius) {
  using Real = long double;
  std::uint32_t nearest = v;
  Real least = 0;
  // Returns whether p comes before `nearest`. The relative error of a square is below three epsilons.
  const auto comes_before = [&](std::uint32_t p, Real square) {
    if (nearest == v) return true;
    if (std::abs(square - least) > 8 * std::numeric_limits<Real>::epsilon() * least) return square < least;
    const int sign = space::exact::compare_distances(points[v], points[p], points[nearest]);
    return sign < 0 || (sign == 0 && points[p] < points[nearest]);
  };
  for (const std::uint32_t p : around) {
    const space::Vector3<Real> d = space::from<Real>(points[v], points[p]);
    const Real square = space::dot(d, d);
    if (p == v || !comes_before(p, square)) continue;
    nearest = p;
    least = square;
  }
  if (nearest == v) return false;
  return std::any_of(around.begin(), around.end(), [&](std::uint32_t p) {
    return p != v && p != nearest && space::RestingBall<Real>(points[v], points[nearest], points[p], radius).rests();
  });
}

/// Changes the cause of each wanted point of `near` from `no_ball_rests` to `hidden` if every ball that touches the
/// point contains another point.
void find_hidden(const space::NeighborhoodSubset& near, double radius, std::vector<UnusedCause>& causes,
                 const std::vector<std::uint8_t>& wanted, Steps& step) {
  Threads threads;
  const space::Cells cells(near.points, radius, threads);
  const auto index_of = [&](space::Site site) { return near.input[cells.input_index()[site]]; };
  space::Cells::Around around_cell(cells);
  std::vector<space::Site> around;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    around.clear();
    for (space::Site v = cells.first_in(cell); v < cells.first_in(cell + 1); ++v) {
      step();
      const std::uint32_t index = index_of(v);
      if (wanted[index] == 0 || causes[index] != UnusedCause::no_ball_rests) continue;
      if (around.empty())
        around_cell.for_each_run(cell, [&](space::Site first, space::Site last) {
          for (space::Site p = first; p < last; ++p) around.push_back(p);
        });
      step(2 * around.size());
      if (is_hidden(v, cells.sites(), around, radius)) causes[index] = UnusedCause::hidden;
    }
  }
}

}  // namespace

std::vector<UnusedPoint> unused_points(std::span<const Point3> points, std::span<const Point3> normals,
                                       std::span<const double> radii, const Surface& surface,
                                       const SurfaceOptions& options) {
  space::check_radii(radii);
  space::check_points(points);
  if (!normals.empty()) space::check_normals(points, normals);
  require_linked(space::arrays_of(surface), points.size());
  require_duplicates("unused_points", surface.duplicates, points.size());

  const GoOn go_on = go_on_of(options.progress, points.size(), surface.triangles.size());
  Steps step(go_on);
  std::vector<UnusedPoint> unused = without_triangle(points.size(), surface);
  const space::Agreement agreement(points, normals, surface.duplicates);
  std::vector<UnusedCause> causes(points.size(), UnusedCause::no_ball_rests);
  for (std::size_t level = 0; level < radii.size(); ++level) {
    std::vector<std::uint8_t> wanted(points.size(), 0);
    bool is_any = false;
    for (const UnusedPoint& point : unused)
      if (causes[point.index] != UnusedCause::blocked) wanted[point.index] = is_any = true;
    if (!is_any) break;
    const space::NeighborhoodSubset near =
        space::neighborhood_subset(points, {}, surface.duplicates, wanted, radii[level]);
    std::vector<std::uint8_t> wanted_here;
    for (const std::uint32_t i : near.input) wanted_here.push_back(wanted[i]);
    raise_causes(near, space::exposed_at(near.points, radii[level], wanted_here, options), agreement, causes, step);
    if (level + 1 == radii.size()) find_hidden(near, radii[level], causes, wanted, step);
  }
  for (UnusedPoint& point : unused) point.cause = causes[point.index];
  return unused;
}

std::vector<UnusedPoint> unused_points(std::span<const Point3> points, std::span<const Point3> normals, double radius,
                                       const Surface& surface, const SurfaceOptions& options) {
  return unused_points(points, normals, std::span(&radius, 1), surface, options);
}

}  // namespace rbpa
