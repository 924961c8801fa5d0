#include "rbpa/hrbpa.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/hierarchy/growth_by_tiles.h"
#include "rbpa/hierarchy/quadtree.h"
#include "rbpa/paper/hrbpa.h"
#include "rbpa/parallel/threads.h"
#include "rbpa/run/assembly.h"
#include "rbpa/run/input.h"

namespace rbpa {
namespace {

/// The levels of a run, from the first to the last.
class Levels {
 public:
  /// Keeps references. The clock of the first level runs from now on.
  Levels(double alpha, const std::function<void(const EndedLevel&)>& ended, std::span<const std::uint32_t> input_index,
         Hierarchy& result)
      : alpha_(alpha), ended_(ended), input_index_(input_index), result_(result) {}

  /// `growth` makes the mesh the complex of one level after another.
  void run(const Ladder& ladder, GrowthByTiles& growth, meshops::Front& front) {
    Level level{.transferred = front.sites()};
    for (;;) {
      const bool is_last = ladder.is_last(level.number);
      level.taking_part = growth.grow(level.number, front);
      end(level, ladder.radius(level.number), is_last, front);
      if (is_last) return;

      // What Front::next_level() would tell of a front on which halfedges are attached to: here triangles are put beside
      // frozen ones, and a level costs no more than its triangles.
      level = {.number = std::clamp(growth.next(level.number), level.number + 1, ladder.end()),
               .transferred = growth.open_sites(),
               .advancing = 2 * front.edges() - 3 * front.faces()};
    }
  }

  /// Of the paper's run, on which every point carried on takes part.
  void end(const paper::Level& level, const meshops::Front& front) {
    end({.number = level.number,
         .transferred = level.transferred,
         .taking_part = level.transferred,
         .advancing = level.advancing},
        level.radius, level.is_last, front);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void end(Level level, const Radius& radius, bool is_last, const meshops::Front& front) {
    // As given: a radius beyond all circumradii is infinite to the run.
    level.alpha = is_last ? alpha_ : radius.value();
    level.triangles = front.faces();
    // Sites may have been looked at in vain: which, depends on the order of the input.
    if (!result_.levels.empty() && level.triangles == result_.levels.back().triangles && !is_last) {
      result_.looked_in_vain += level.taking_part;
      return;
    }
    level.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    result_.levels.push_back(level);
    if (ended_) ended_({result_.levels.back(), front, input_index_});
    start_ = Clock::now();
  }

  double alpha_;
  const std::function<void(const EndedLevel&)>& ended_;
  std::span<const std::uint32_t> input_index_;
  Hierarchy& result_;
  Clock::time_point start_ = Clock::now();
};

/// α₀: half the side of the smallest leaf of a quadtree.
double least_radius(const Sites& sites, std::size_t leaf_capacity, const std::function<void()>& ask) {
  long double side = 0;
  if (sites.beyond().empty()) {
    const Quadtree<double> tree(sites.grid().points(), leaf_capacity);
    side = std::ldexp(static_cast<long double>(tree.smallest_side(ask)), -sites.window().exponent);
  } else {
    side = Quadtree<long double>(sites.points(), leaf_capacity).smallest_side(ask);
  }
  using Limits = std::numeric_limits<double>;
  return static_cast<double>(std::clamp<long double>(side / 2, Limits::denorm_min(), Limits::max()));
}

}  // namespace

Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options) {
  const std::size_t leaf_capacity = options.leaf_capacity.value_or(usual_leaf_capacity(options.search));
  meshops::require(leaf_capacity > 0, "hrbpa: leaf_capacity is 0, expected at least 1");
  check(points, alpha);
  Hierarchy result;
  Threads threads = threads_for(points.size(), options.threads);
  Assembly assembly(points, result.complex, threads, options.progress);
  const Sites& sites = assembly.sites();
  if (assembly.are_collinear()) {
    assembly.finish(assembly.front());
    return result;
  }
  const bool is_above_all = sites.beyond().empty() && sites.window().scaled(Radius::of(alpha)).is_infinite();
  const Radius radius = is_above_all ? Radius() : Radius::of(alpha);
  Monitor monitor(options.progress, sites.size());
  Levels levels(alpha, options.level_ended, sites.input_index(), result);
  if (options.search == Search::paper) {
    meshops::Front front = assembly.front();
    result.least_radius = paper::hrbpa(sites.points(), radius, leaf_capacity, front, monitor,
                                       [&](const paper::Level& level) { levels.end(level, front); });
    assembly.finish(front);
    return result;
  }
  result.least_radius = least_radius(sites, leaf_capacity, asking(options.progress, sites.size()));
  const Ladder ladder(result.least_radius, radius, sites.diameter_bound());
  GrowthByTiles growth(sites, ladder, threads, monitor);
  meshops::Front front = growth.begin(assembly);
  levels.run(ladder, growth, front);
  assembly.finish(front);
  return result;
}

std::size_t level_of(const Hierarchy& hierarchy, std::size_t face) {
  return static_cast<std::size_t>(std::upper_bound(hierarchy.levels.begin(), hierarchy.levels.end(), face,
                                                   [](std::size_t f, const Level& l) { return f < l.triangles; }) -
                                  hierarchy.levels.begin());
}

}  // namespace rbpa
