#include "rbpa/space/solid/solid_locator.h"

#include <algorithm>
#include <cmath>

#include "meshops/core/contract.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa {
namespace {

/// Returns the number of the cell that contains x, or is nearest to x, among `cells` equal cells from `low` to `high`.
/// Coordinates are halved so that no difference is beyond the range of double.
std::size_t cell_along(double x, double low, double high, std::size_t cells) {
  const double ratio = (x / 2 - low / 2) / (high / 2 - low / 2) * static_cast<double>(cells);
  return ratio >= 1 ? std::min(static_cast<std::size_t>(std::min(ratio, 1e6)), cells - 1) : 0;
}

}  // namespace

/// The working memory of a query.
struct SolidLocator::Walk {
  std::vector<std::uint32_t> around;  // tetrahedra that contain the query
};

SolidLocator::SolidLocator(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 4>> simplices,
                           std::span<const std::array<std::uint32_t, 4>> neighbors)
    : points_(points), simplices_(simplices), neighbors_(neighbors) {
  meshops::require_one_each("SolidLocator", neighbors.size(), "rows of neighbors", simplices.size(), "tetrahedra");
  for (std::size_t t = 0; t < simplices.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k)
      meshops::require(
          simplices[t][k] < points.size() && (neighbors[t][k] == Solid::none || neighbors[t][k] < simplices.size()),
          "SolidLocator: a corner or a neighbor does not exist, expected indices of points and of tetrahedra");
  if (simplices.empty()) return;
  space::Box box;
  for (const auto& row : simplices)
    for (const std::uint32_t corner : row) box.include(points[corner]);
  low_ = box.low;
  high_ = box.high;
  // Cells are cubes, about one for twenty tetrahedra. The volume of a flat box counts as if each side were at least
  // 10⁻⁶ of the longest, and each axis has at most 1,024 cells.
  const std::array<double, 3> extent = {high_.x / 2 - low_.x / 2, high_.y / 2 - low_.y / 2, high_.z / 2 - low_.z / 2};
  const double longest = *std::max_element(extent.begin(), extent.end());
  double volume = 1;
  for (const double e : extent) volume *= std::max(e / longest, 1e-6);
  const double side = std::cbrt(volume * 20 / static_cast<double>(simplices.size()));
  for (std::size_t axis = 0; axis < 3; ++axis)
    cells_[axis] = static_cast<std::size_t>(std::clamp(extent[axis] / longest / side, 1.0, 1024.0));
  start_.assign(cells_[0] * cells_[1] * cells_[2], Solid::none);
  for (std::uint32_t t = 0; t < simplices.size(); ++t)
    for (const std::uint32_t corner : simplices[t])
      if (std::uint32_t& start = start_[cell_of(points[corner])]; start == Solid::none) start = t;
  // Cells without a point start at the tetrahedron of the last cell with a point.
  std::uint32_t last = 0;
  for (std::uint32_t& start : start_) last = start = start == Solid::none ? last : start;
}

std::size_t SolidLocator::cell_of(const Point3& p) const {
  const std::size_t x = cell_along(p.x, low_.x, high_.x, cells_[0]), y = cell_along(p.y, low_.y, high_.y, cells_[1]),
                    z = cell_along(p.z, low_.z, high_.z, cells_[2]);
  return (z * cells_[1] + y) * cells_[0] + x;
}

std::uint32_t SolidLocator::find(const Point3& query, Walk& walk) const {
  if (simplices_.empty() || !is_finite(query)) return Solid::none;
  const auto side = [&](std::uint32_t t, std::size_t k) {
    const auto& face = space::outer_faces[k];
    const auto& corners = simplices_[t];
    return space::orientation(points_[corners[face[0]]], points_[corners[face[1]]], points_[corners[face[2]]], query);
  };
  std::uint32_t t = start_[cell_of(query)], before = Solid::none;
  for (std::size_t steps = 0;; ++steps) {
    meshops::require(steps <= simplices_.size(),
                     "SolidLocator: found a triangulation that is not Delaunay, expected the result of solid(points, "
                     "infinity) for these points");
    std::uint32_t next = t;
    for (std::size_t k = 0; k < 4 && next == t; ++k) {
      const std::uint32_t beyond = neighbors_[t][k];
      if (beyond == before && before != Solid::none) continue;  // the query is not beyond the face to `before`
      if (side(t, k) <= 0) continue;
      if (beyond == Solid::none) return Solid::none;
      next = beyond;
    }
    if (next == t) break;
    before = t;
    t = next;
  }
  // All tetrahedra that contain the query are connected through faces that contain the query.
  walk.around.assign(1, t);
  std::uint32_t first = t;
  for (std::size_t i = 0; i < walk.around.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t beyond = neighbors_[walk.around[i]][k];
      if (beyond == Solid::none || side(walk.around[i], k) != 0) continue;
      if (std::find(walk.around.begin(), walk.around.end(), beyond) != walk.around.end()) continue;
      walk.around.push_back(beyond);
      first = std::min(first, beyond);
    }
  return first;
}

std::vector<std::uint32_t> SolidLocator::find(std::span<const Point3> queries,
                                              const SolidLocateOptions& options) const {
  std::vector<std::uint32_t> found(queries.size());
  Threads threads = threads_for(queries.size(), options.threads);
  CheckpointOfThreads checkpoint(options.go_on);
  constexpr std::size_t queries_at_a_time = 1u << 10;
  for_each_part(threads, queries.size(), queries_at_a_time, [&](std::size_t begin, std::size_t end) {
    Walk walk;
    for (std::size_t i = begin; i < end; ++i) found[i] = find(queries[i], walk);
    checkpoint();
  });
  return found;
}

}  // namespace rbpa
