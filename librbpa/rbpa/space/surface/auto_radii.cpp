#include "rbpa/space/surface/auto_radii.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>

#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/radii/cube_root.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/surface/neighbors/find_nearest.h"
#include "rbpa/space/surface/neighbors/fit_plane.h"
#include "rbpa/space/surface/spacing/tangent_cell.h"

namespace rbpa {
namespace {

// The numbers are chosen by experiments: docs/explanation/surfaces.md, section 20.
constexpr std::size_t neighbors = 32;
constexpr double most_of_all = 0.99;  // fraction of the points whose gaps are ordinary
constexpr double beyond_most = 2;     // a gap more than this many times the largest ordinary one is an exception
constexpr double margin = 1.25;       // because surfaces are not flat, and not all gaps are seen
constexpr double ladder = 2;          // ratio of radii: a ball larger than needed by this factor loses detail
constexpr double some_of_all = 0.05;  // fraction of the points that get a smaller radius of their own
constexpr std::size_t most_radii = 4;
constexpr double least_flatness = 0.5;  // least flatness of the neighbors of a point on a surface
// Least fraction of the neighbors of an ordinary point that are at least as near to the point as to their own neighbors
constexpr double least_returned = 0.5;
// Points on no surface are left out if they are at most this fraction of all points
constexpr double most_strangers = 0.3;
constexpr double none = -1;

/// The gap around each point, or none, in the order of `near`.
struct Gaps {
  space::Neighborhoods near;
  std::vector<double> gap;
  std::vector<double> least;  // for each point, nearest_circumradius() or none; used if no point has a gap
};

/// Returns whether a point is on a surface, by its neighbors. An outlier is farther from its neighbors than these are
/// from their own neighbors, or has neighbors on all sides.
bool is_on_surface(const space::Neighborhoods& near, std::size_t i, double flatness) {
  if (flatness < least_flatness) return false;
  const auto squared = [&](std::uint32_t p, std::uint32_t q) {
    const Point3 &a = near.points[p], &b = near.points[q];
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z;
  };
  std::size_t returned = 0;
  for (const std::uint32_t k : near.around(i))
    returned += squared(static_cast<std::uint32_t>(i), k) <= squared(k, near.around(k).back());
  return static_cast<double>(returned) >= least_returned * static_cast<double>(near.count);
}

/// Replaces `result` by the neighbors relative to point i, times 2^-exponent, so that no square overflows or
/// underflows. Returns the exponent.
int relative(const space::Neighborhoods& near, std::size_t i, std::vector<Point3>& result) {
  const Point3& p = near.points[i];
  const auto around = near.around(i);
  const Point3& last = near.points[around.back()];
  const int exponent = std::ilogb(std::max({std::abs(last.x - p.x), std::abs(last.y - p.y), std::abs(last.z - p.z)}));
  const auto scaled = [&](double value) { return std::ldexp(value, -exponent); };
  result.clear();
  for (const std::uint32_t k : around) {
    const Point3& q = near.points[k];
    result.push_back({scaled(q.x - p.x), scaled(q.y - p.y), scaled(q.z - p.z)});
  }
  return exponent;
}

/// Removes the gaps of points on no surface, if they are few, and of points most of whose neighbors are on no surface.
void leave_out_strangers(Gaps& gaps, const std::vector<char>& on_surface) {
  const auto all = std::count(on_surface.begin(), on_surface.end(), 0);
  if (static_cast<double>(all) > most_strangers * static_cast<double>(on_surface.size())) return;
  std::vector<char> ordinary = on_surface;
  for (std::size_t i = 0; i < ordinary.size(); ++i) {
    std::size_t strangers = 0;
    for (const std::uint32_t k : gaps.near.around(i)) strangers += on_surface[k] == 0;
    if (2 * strangers > gaps.near.count) ordinary[i] = 0;
  }
  for (std::size_t i = 0; i < ordinary.size(); ++i)
    if (ordinary[i] == 0) gaps.gap[i] = none;
}

Gaps gaps_of(std::vector<Point3> points, const SurfaceOptions& options) {
  constexpr std::size_t points_at_a_time = 1024;
  const Checkpoint go_on = checkpoint_of(options.progress, points.size());
  Threads threads(points.size() < 1000 ? 1 : options.threads);  // for few points, another thread would start too late
  space::PlanesOfPoints planes = space::fit_planes<double>(std::move(points), neighbors, threads, go_on);
  const std::vector<Point3> normals = std::move(planes.normals);
  Gaps gaps{std::move(planes.near), {}, {}};
  const std::size_t count = gaps.near.points.size();
  gaps.gap.assign(count, none);
  gaps.least.assign(count, none);
  std::mutex one_call;
  std::vector<char> on_surface(count, 0);
  for_each_part(threads, count, points_at_a_time, [&](std::size_t first, std::size_t last) {
    std::vector<Point3> around;
    for (std::size_t i = first; i < last; ++i) {
      const int exponent = relative(gaps.near, i, around);
      // A corner within half of the farthest neighbor's distance is nearer to the point than to any point beyond the
      // neighbors.
      const Point3& end = around.back();
      const double farthest = std::sqrt(end.x * end.x + end.y * end.y + end.z * end.z);
      const double reach = around.size() + 1 == count ? farthest : farthest / 2;
      on_surface[i] = is_on_surface(gaps.near, i, planes.flatness[i]);
      if (const auto gap = space::gap_around(around, normals[i], reach)) gaps.gap[i] = std::ldexp(*gap, exponent);
      if (const auto least = space::nearest_circumradius(around)) gaps.least[i] = std::ldexp(*least, exponent);
    }
    if (!go_on) return;
    const std::lock_guard lock(one_call);
    go_on();
  });
  leave_out_strangers(gaps, on_surface);
  return gaps;
}

/// Returns for each point the largest gap of at most `largest` in its neighborhood; `none` if there is no such gap.
std::vector<double> needs(const Gaps& gaps, double largest) {
  std::vector<double> need(gaps.gap.size(), none);
  for (std::size_t i = 0; i < need.size(); ++i) {
    const auto take = [&](std::size_t k) {
      if (gaps.gap[k] <= largest) need[i] = std::max(need[i], gaps.gap[k]);
    };
    take(i);
    for (const std::uint32_t k : gaps.near.around(i)) take(k);
  }
  return need;
}

std::vector<double> without_none(std::vector<double> values) {
  std::erase(values, none);
  std::sort(values.begin(), values.end());
  return values;
}

/// Returns half the diagonal of the box of distinct points; nothing if all points are on one line.
std::vector<double> half_diagonal(std::span<const Point3> points) {
  const auto is_on_line = [&](const Point3& p) { return space::are_collinear(points[0], points[1], p); };
  if (std::all_of(points.begin(), points.end(), is_on_line)) return {};
  const space::Box box = space::box_of(points);
  const space::Vector3<double> d = space::from<double>(box.low, box.high);
  return {std::sqrt(space::dot(d, d)) / 2};
}

std::vector<double> radii_of(const Gaps& gaps) {
  const std::vector<double> sorted = without_none(gaps.gap);
  if (sorted.empty()) {
    const std::vector<double> least = without_none(gaps.least);
    if (least.empty()) return half_diagonal(gaps.near.points);
    return {margin * least[least.size() / 2]};
  }
  const double most = sorted[static_cast<std::size_t>(most_of_all * static_cast<double>(sorted.size() - 1))];
  const double largest = *(std::upper_bound(sorted.begin(), sorted.end(), beyond_most * most) - 1);
  std::vector<double> need = without_none(needs(gaps, largest)), radii;
  const auto some = static_cast<std::size_t>(some_of_all * static_cast<double>(need.size()));
  // Steps are larger if densities differ too much for this number of radii.
  static_assert(most_radii == 4);
  const double step = std::max(ladder, cube_root(need.back() / need[some]));
  while (radii.size() < most_radii && need.size() > some) {
    radii.push_back(margin * need.back());
    need.erase(std::lower_bound(need.begin(), need.end(), need.back() / step), need.end());
  }
  std::reverse(radii.begin(), radii.end());
  return radii;
}

}  // namespace

std::vector<double> auto_radii(std::span<const Point3> points, const SurfaceOptions& options) {
  space::check_points(points);
  double greatest = 0;
  for (const Point3& p : points) greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (greatest == 0) return {};
  // Coordinates are scaled so that the largest is about 1: distances below 1e-160 count as 0.
  const int exponent = std::ilogb(greatest);
  const auto scaled = [&](double value) { return std::ldexp(value, -exponent); };
  std::vector<Point3> distinct;
  distinct.reserve(points.size());
  for (const Point3& p : points) distinct.push_back({scaled(p.x), scaled(p.y), scaled(p.z)});
  sort_unique(distinct);
  if (distinct.size() < 3) return {};
  std::vector<double> radii = radii_of(gaps_of(std::move(distinct), options));
  for (double& radius : radii) radius = std::ldexp(radius, exponent);
  std::erase_if(radii, [](double radius) { return radius == 0 || std::isinf(radius); });
  return radii;
}

std::optional<double> radius_with_triangles(std::span<const Point3> points, std::span<const Point3> normals,
                                            const SurfaceOptions& options) {
  if (!normals.empty()) space::check_normals(points, normals);
  for (const double radius : auto_radii(points, options)) {
    const Surface surface =
        normals.empty() ? exposed_triangles(points, radius, options) : rbpa::surface(points, normals, radius, options);
    if (!surface.triangles.empty()) return radius;
  }
  return std::nullopt;
}

}  // namespace rbpa
