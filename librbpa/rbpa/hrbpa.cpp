#include "rbpa/hrbpa.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <type_traits>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/collinear.h"
#include "rbpa/hierarchy/growth_by_pivots.h"
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
  /// Keeps references.
  Levels(double alpha, const std::function<void(const EndedLevel&)>& ended, std::span<const std::uint32_t> input_index,
         meshops::Front& front, Hierarchy& result)
      : alpha_(alpha), ended_(ended), input_index_(input_index), front_(front), result_(result) {}

  /// `Growth` makes the mesh the complex of one level after another, as GrowthByTiles does.
  template <typename Real, typename Growth>
  void run(const Ladder<Real>& ladder, Growth& growth) {
    Level level{.transferred = front_.sites()};
    for (;;) {
      const bool is_last = ladder.is_last(level.number);
      level.taking_part = growth.grow(level.number, front_);
      end(level, ladder.radius(level.number), is_last);
      if (is_last) return;

      meshops::LevelTransfer transfer = front_.next_level();
      const std::size_t transferred = transfer.carried.size();
      const int next = growth.next(level.number, std::move(transfer.carried));
      level = {.number = std::clamp(next, level.number + 1, ladder.end()),
               .transferred = transferred,
               .advancing = transfer.reactivated};
    }
  }

  /// Of the paper's run, on which every point carried on takes part.
  void end(const paper::Level& level) {
    end({.number = level.number,
         .transferred = level.transferred,
         .taking_part = level.transferred,
         .advancing = level.advancing},
        level.radius, level.is_last);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void end(Level level, const Radius& radius, bool is_last) {
    // As given: a radius beyond all circumradii is infinite to the run.
    level.alpha = is_last ? alpha_ : radius.value();
    level.triangles = front_.faces();
    // Sites may have been looked at in vain: which, depends on the order of the input.
    if (!result_.levels.empty() && level.triangles == result_.levels.back().triangles && !is_last) {
      result_.looked_in_vain += level.taking_part;
      return;
    }
    level.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    result_.levels.push_back(level);
    if (ended_) ended_({result_.levels.back(), front_, input_index_});
    start_ = Clock::now();
  }

  double alpha_;
  const std::function<void(const EndedLevel&)>& ended_;
  std::span<const std::uint32_t> input_index_;
  meshops::Front& front_;
  Hierarchy& result_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options) {
  const std::size_t leaf_capacity = options.leaf_capacity.value_or(usual_leaf_capacity(options.search));
  meshops::require(leaf_capacity > 0, "hrbpa: leaf_capacity is 0, expected at least 1");
  check(points, alpha);
  Hierarchy result;
  Threads threads = threads_for(points.size(), options.threads);
  const auto run = [&]<typename Real>(Radius radius, Real grid_unit, double below_all) {
    Assembly<Real> assembly(points, result.complex, threads);
    const auto& grid = assembly.grid();
    if (!are_collinear(grid.points())) {
      Report report(options.progress, grid.points().size());
      Levels levels(alpha, options.level_ended, grid.input_index(), assembly.front(), result);
      if (options.search == Search::paper) {
        result.least_radius = paper::hrbpa(grid.points(), radius, leaf_capacity, assembly.front(), report,
                                           [&](const paper::Level& level) { levels.end(level); });
      } else {
        const Real side = Quadtree<Real>(grid.points(), leaf_capacity).smallest_side();
        result.least_radius =
            std::clamp(static_cast<double>(side / 2), std::max(below_all, std::numeric_limits<double>::denorm_min()),
                       std::numeric_limits<double>::max());
        const Ladder<Real> ladder(result.least_radius, radius, grid.diameter_bound());
        if constexpr (std::is_same_v<Real, double>) {
          GrowthByTiles growth(grid, ladder, threads, report);
          levels.run(ladder, growth);
        } else {
          // Extreme exponents do without tiles.
          GrowthByPivots growth(grid, ladder, grid_unit, report);
          levels.run(ladder, growth);
        }
      }
    }
    assembly.finish();
  };
  with_arithmetic_for(points, alpha, run);
  return result;
}

std::size_t level_of(const Hierarchy& hierarchy, std::size_t face) {
  return static_cast<std::size_t>(std::upper_bound(hierarchy.levels.begin(), hierarchy.levels.end(), face,
                                                   [](std::size_t f, const Level& l) { return f < l.triangles; }) -
                                  hierarchy.levels.begin());
}

}  // namespace rbpa
