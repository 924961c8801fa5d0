#include "rbpa/plane/triangles_by_level.h"

#include <cmath>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/run/input.h"
#include "rbpa/plane/arrays/keep_triangles.h"
#include "rbpa/plane/arrays/outlined_triangles.h"
#include "rbpa/plane/collinear.h"
#include "rbpa/plane/hierarchy/least_radius.h"
#include "rbpa/plane/hierarchy/levelled_triangles.h"
#include "rbpa/plane/link_triangles.h"
#include "rbpa/plane/patches/find_triangles.h"

namespace rbpa {
namespace {

/// Fills in result.level and result.levels from the level number of each triangle; leaves out levels without a triangle
/// between the first and the last.
void part_by_level(std::span<const std::uint32_t> numbers, const Ladder& ladder, double alpha,
                   TrianglesByLevel& result) {
  const auto end = static_cast<std::size_t>(ladder.end());
  std::vector<std::size_t> count(end + 1, 0);
  for (const std::uint32_t number : numbers) ++count[number];
  std::vector<std::uint16_t> position(end + 1, 0);
  std::size_t triangles = 0;
  for (std::size_t number = 0; number <= end; ++number) {
    position[number] = static_cast<std::uint16_t>(result.levels.size());
    triangles += count[number];
    const bool is_last = number == end;
    if (count[number] != 0 || number == 0 || is_last)
      result.levels.push_back({.alpha = is_last ? alpha : ladder.radius(static_cast<int>(number)).value(),
                               .number = static_cast<int>(number),
                               .triangles = triangles});
  }
  result.level.resize(numbers.size());
  for (std::size_t t = 0; t < numbers.size(); ++t) result.level[t] = position[numbers[t]];
}

}  // namespace

TrianglesByLevel triangles_by_level(std::span<const Point> points, double alpha,
                                    const TrianglesByLevelOptions& options) {
  meshops::require(options.leaf_capacity > 0, "triangles_by_level: leaf_capacity is 0, expected at least 1");
  check(points, alpha);
  TrianglesByLevel result;
  AlphaComplex& complex = result.complex;
  Threads threads = threads_for(points.size(), options.threads);
  std::optional<Sites> sites(std::in_place, points, threads, checkpoint_of(options.progress, points.size()));
  complex.distinct = sites->size();
  complex.duplicates = sites->duplicates();
  if (are_collinear(points, go_on_of(options.progress, points.size()))) {
    complex.isolated = isolated_in(complex, points.size());
    return result;
  }
  result.least_radius = least_radius(*sites, options.leaf_capacity, checkpoint_of(options.progress, sites->size()));
  const Ladder ladder(result.least_radius, sites->reachable(alpha), sites->diameter_bound());
  LevelledTriangles list(*sites, ladder, points.size(), threads);
  if (options.boundary) {
    OutlinedTriangles outlined(sites->size(), sites->input_index(), list);
    find_triangles(*sites, ladder.radius(ladder.end()), options.progress, threads, outlined);
    complex.boundary = outlined.boundary();
  } else {
    find_triangles(*sites, ladder.radius(ladder.end()), options.progress, threads, list);
  }
  sites.reset();  // frees memory before the list becomes the result
  const Checkpoint checkpoint = checkpoint_of(options.progress, complex.distinct, list.size());
  meshops::FreshVector<std::uint32_t> numbers;
  complex.triangles = list.sorted(threads, numbers, checkpoint);
  part_by_level(numbers, ladder, alpha, result);
  if (std::isfinite(alpha)) complex.isolated = isolated_in(complex, points.size());
  if (options.neighbors)
    complex.neighbors = link_triangles(complex.triangles, points.size(), [&checkpoint] {
      if (checkpoint) checkpoint();
      return true;
    });
  return result;
}

}  // namespace rbpa
