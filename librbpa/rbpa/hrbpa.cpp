#include "rbpa/hrbpa.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/plane/hierarchy/growth_by_tiles.h"
#include "rbpa/plane/hierarchy/least_radius.h"
#include "rbpa/plane/hierarchy/level_record.h"
#include "rbpa/plane/hierarchy/levels_at_once.h"
#include "rbpa/plane/mesh/assembly.h"
#include "rbpa/plane/triangles_by_level.h"

namespace rbpa {
namespace {

using Clock = std::chrono::steady_clock;

/// Runs all levels, from the first to the last: on each, `growth` makes the mesh the complex of the level's radius.
void run_levels(const Ladder& ladder, GrowthByTiles& growth, meshops::Front& front, LevelRecord& record) {
  Level level{.transferred = front.sites()};
  for (;;) {
    const bool is_last = ladder.is_last(level.number);
    level.taking_part = growth.grow(level.number, front);
    record.end(level, ladder.radius(level.number), is_last, front);
    if (is_last) return;

    // On a front that grows by attached triangles, Front::next_level() counts these halfedges. `growth` puts
    // triangles at frozen halfedges instead, and the cost of a level is linear in its triangles.
    level = {.number = std::clamp(growth.next(level.number), level.number + 1, ladder.end()),
             .transferred = growth.open_sites(),
             .advancing = 2 * front.edges() - 3 * front.faces()};
  }
}

}  // namespace

Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options) {
  const std::size_t leaf_capacity = options.leaf_capacity.value_or(usual_leaf_capacity);
  meshops::require(leaf_capacity > 0, "hrbpa: leaf_capacity is 0, expected at least 1");
  check(points, alpha);
  Hierarchy result;
  Threads threads = threads_for(points.size(), options.threads);
  Assembly assembly(points, result.complex, threads, options.progress);
  const Sites& sites = assembly.sites();
  if (assembly.are_collinear(options.progress)) {
    assembly.finish(assembly.front());
    return result;
  }
  Monitor monitor(options.progress, sites.size());
  const Clock::time_point start = Clock::now();
  LevelRecord record(alpha, options.level_ended, sites.input_index(), result);
  result.least_radius = least_radius(sites, leaf_capacity, checkpoint_of(options.progress, sites.size()));
  const Ladder ladder(result.least_radius, sites.reachable(alpha), sites.diameter_bound());
  if (options.level_ended) {
    GrowthByTiles growth(sites, ladder, threads, monitor);
    meshops::Front front = growth.begin(assembly);
    run_levels(ladder, growth, front, record);
    assembly.finish(front);
  } else {
    LevelsAtOnce at_once(sites, ladder, threads, monitor);
    auto assembled = at_once.lay(assembly);
    result.levels = at_once.levels(alpha);
    result.levels.front().seconds = std::chrono::duration<double>(Clock::now() - start).count();
    assembly.finish(std::move(assembled));
  }
  return result;
}

std::size_t level_of(const Hierarchy& hierarchy, std::size_t face) {
  return static_cast<std::size_t>(std::upper_bound(hierarchy.levels.begin(), hierarchy.levels.end(), face,
                                                   [](std::size_t f, const Level& l) { return f < l.triangles; }) -
                                  hierarchy.levels.begin());
}

}  // namespace rbpa
