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
    using Clock = std::chrono::steady_clock;
    auto start = Clock::now();
    Level level{.transferred = front_.sites()};
    for (;; start = Clock::now()) {
      const bool is_last = ladder.is_last(level.number);
      // As given: a radius beyond all circumradii is infinite to the ladder.
      level.alpha = is_last ? alpha_ : ladder.radius(level.number).value();
      level.taking_part = growth.grow(level.number, front_);
      level.triangles = front_.faces();
      level.seconds += std::chrono::duration<double>(Clock::now() - start).count();
      const bool is_left_out = end(level, is_last);
      if (is_last) return;

      meshops::LevelTransfer transfer = front_.next_level();
      const std::size_t transferred = transfer.carried.size();
      const int next = growth.next(level.number, std::move(transfer.carried));
      level = {.number = std::clamp(next, level.number + 1, ladder.end()),
               .transferred = transferred,
               .advancing = transfer.reactivated,
               .seconds = is_left_out ? level.seconds : 0};
    }
  }

 private:
  /// Returns: whether the level is left out.
  bool end(const Level& level, bool is_last) {
    // Sites may have been looked at in vain: which, depends on the order of the input.
    if (!result_.levels.empty() && level.triangles == result_.levels.back().triangles && !is_last) {
      result_.looked_in_vain += level.taking_part;
      return true;
    }
    result_.levels.push_back(level);
    if (ended_) ended_({result_.levels.back(), front_, input_index_});
    return false;
  }

  double alpha_;
  const std::function<void(const EndedLevel&)>& ended_;
  std::span<const std::uint32_t> input_index_;
  meshops::Front& front_;
  Hierarchy& result_;
};

}  // namespace

Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options) {
  meshops::require(options.leaf_capacity > 0, "hrbpa: leaf_capacity is 0, expected at least 1");
  check(points, alpha);
  Hierarchy result;
  Threads threads = threads_for(points.size(), options.threads);
  const auto run = [&]<typename Real>(Radius radius, Real grid_unit, double below_all) {
    Assembly<Real> assembly(points, result.complex, threads, options.progress);
    const auto& grid = assembly.grid();
    if (!are_collinear(grid.points())) {
      const Real side = Quadtree<Real>(grid.points(), options.leaf_capacity)
                            .smallest_side(asking(options.progress, grid.points().size()));
      result.least_radius =
          std::clamp(static_cast<double>(side / 2), std::max(below_all, std::numeric_limits<double>::denorm_min()),
                     std::numeric_limits<double>::max());
      const Ladder<Real> ladder(result.least_radius, radius, grid.diameter_bound());
      Report report(options.progress, grid.points().size());
      Levels levels(alpha, options.level_ended, grid.input_index(), assembly.front(), result);
      if constexpr (std::is_same_v<Real, double>) {
        GrowthByTiles growth(grid, ladder, threads, report);
        levels.run(ladder, growth);
      } else {
        // Extreme exponents do without tiles.
        GrowthByPivots growth(grid, ladder, grid_unit, report);
        levels.run(ladder, growth);
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
