#include "rbpa/hrbpa.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/hierarchy/growth_by_tiles.h"
#include "rbpa/hierarchy/quadtree.h"
#include "rbpa/parallel/threads.h"
#include "rbpa/run/assembly.h"
#include "rbpa/run/input.h"

namespace rbpa {
namespace {

/// The levels of a run, from the first to the last.
class Levels {
 public:
  /// Keeps references.
  Levels(double alpha, const std::function<void(const EndedLevel&)>& ended, Hierarchy& result)
      : alpha_(alpha), ended_(ended), result_(result) {}

  /// `growth` makes the mesh the complex of one level after another.
  void run(const Ladder& ladder, GrowthByTiles growth, Assembly& assembly) {
    input_index_ = assembly.sites().input_index();
    const auto start = Clock::now();
    meshops::Front front = growth.begin(assembly);
    run(ladder, growth, front, start);
    assembly.finish(front);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void run(const Ladder& ladder, GrowthByTiles& growth, meshops::Front& front, Clock::time_point start) {
    Level level{.transferred = front.sites()};
    for (;; start = Clock::now()) {
      const bool is_last = ladder.is_last(level.number);
      // As given: a radius beyond all circumradii is infinite to the ladder.
      level.alpha = is_last ? alpha_ : ladder.radius(level.number).value();
      level.taking_part = growth.grow(level.number, front);
      level.triangles = front.faces();
      level.seconds += std::chrono::duration<double>(Clock::now() - start).count();
      const bool is_left_out = end(level, is_last, front);
      if (is_last) return;

      meshops::LevelTransfer transfer = front.next_level();
      const std::size_t transferred = transfer.carried.size();
      const int next = growth.next(level.number, std::move(transfer.carried));
      level = {.number = std::clamp(next, level.number + 1, ladder.end()),
               .transferred = transferred,
               .advancing = transfer.reactivated,
               .seconds = is_left_out ? level.seconds : 0};
    }
  }

  /// Returns: whether the level is left out.
  bool end(const Level& level, bool is_last, const meshops::Front& front) {
    // Sites may have been looked at in vain: which, depends on the order of the input.
    if (!result_.levels.empty() && level.triangles == result_.levels.back().triangles && !is_last) {
      result_.looked_in_vain += level.taking_part;
      return true;
    }
    result_.levels.push_back(level);
    if (ended_) ended_({result_.levels.back(), front, input_index_});
    return false;
  }

  double alpha_;
  const std::function<void(const EndedLevel&)>& ended_;
  std::span<const std::uint32_t> input_index_;
  Hierarchy& result_;
};

/// α₀: half the side of the smallest leaf of a quadtree.
double least_radius(const Sites& sites, std::size_t leaf_capacity) {
  long double side = 0;
  if (sites.beyond().empty()) {
    side = std::ldexp(static_cast<long double>(Quadtree<double>(sites.grid().points(), leaf_capacity).smallest_side()),
                      -sites.window().exponent);
  } else {
    side = Quadtree<long double>(sites.points(), leaf_capacity).smallest_side();
  }
  using Limits = std::numeric_limits<double>;
  return static_cast<double>(std::clamp<long double>(side / 2, Limits::denorm_min(), Limits::max()));
}

}  // namespace

Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options) {
  meshops::require(options.leaf_capacity > 0, "hrbpa: leaf_capacity is 0, expected at least 1");
  check(points, alpha);
  Hierarchy result;
  Threads threads = threads_for(points.size(), options.threads);
  Assembly assembly(points, result.complex, threads);
  const Sites& sites = assembly.sites();
  if (assembly.are_collinear()) {
    assembly.finish(assembly.front());
    return result;
  }
  result.least_radius = least_radius(sites, options.leaf_capacity);
  const bool is_above_all = sites.beyond().empty() && sites.window().scaled(Radius::of(alpha)).is_infinite();
  const Ladder ladder(result.least_radius, is_above_all ? Radius() : Radius::of(alpha), sites.diameter_bound());
  Report report(options.progress, sites.size());
  Levels levels(alpha, options.level_ended, result);
  levels.run(ladder, GrowthByTiles(sites, ladder, threads, report), assembly);
  return result;
}

std::size_t level_of(const Hierarchy& hierarchy, std::size_t face) {
  return static_cast<std::size_t>(std::upper_bound(hierarchy.levels.begin(), hierarchy.levels.end(), face,
                                                   [](std::size_t f, const Level& l) { return f < l.triangles; }) -
                                  hierarchy.levels.begin());
}

}  // namespace rbpa
