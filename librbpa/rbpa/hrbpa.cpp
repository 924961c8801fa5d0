#include "rbpa/hrbpa.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>

#include "meshops/core/contract.h"
#include "meshops/front/engine.h"
#include "rbpa/collinear.h"
#include "rbpa/hierarchy/policy.h"
#include "rbpa/hierarchy/quadtree.h"
#include "rbpa/run/assembly.h"
#include "rbpa/run/input.h"

namespace rbpa {
namespace {

template <typename Real>
class HierarchicalRun {
 public:
  HierarchicalRun(const PointGrid<Real>& grid, double least, double alpha, Radius radius, Real grid_unit,
                  const HierarchyOptions& options)
      : input_index_(grid.input_index()),
        level_ended_(options.level_ended),
        alpha_(alpha),
        ladder_(least, radius, grid.diameter_bound()),
        pivot_(grid, Radius(), grid_unit),
        apexes_(pivot_),
        seeds_(grid, ladder_, pivot_, apexes_),
        report_(options.progress, grid.points().size()),
        policy_(grid, ladder_, apexes_, seeds_, report_) {}

  /// Fills in the levels.
  void advance(meshops::Front& front, Hierarchy& result) {
    std::vector<Level>& levels = result.levels;
    std::vector<meshops::Site> free(front.sites());
    std::iota(free.begin(), free.end(), 0);
    Level level{.alpha = alpha(0), .transferred = free.size(), .taking_part = free.size()};
    for (;;) {
      const auto start = std::chrono::steady_clock::now();
      policy_.begin(level.number);
      seeds_.begin(level.number, std::move(free));
      meshops::advance(front, policy_, report_);
      level.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      // Sites may have been looked at in vain: which, depends on the order of the input.
      const bool in_vain =
          !levels.empty() && front.faces() == levels.back().triangles && !ladder_.is_last(level.number);
      level.triangles = front.faces();
      if (in_vain) {
        result.looked_in_vain += level.taking_part;
      } else {
        levels.push_back(level);
        if (level_ended_) level_ended_({levels.back(), front, input_index_});
      }
      if (ladder_.is_last(level.number)) break;

      const meshops::LevelTransfer transfer = front.next_level();
      const int next = next_level(level.number, transfer.carried);
      level = {.alpha = alpha(next),
               .number = next,
               .transferred = transfer.carried.size(),
               .advancing = transfer.reactivated,
               .seconds = in_vain ? level.seconds : 0};
      free.clear();
      for (const meshops::Site s : transfer.carried) {
        if (seeds_.wake(s) > next) continue;
        ++level.taking_part;
        if (front.is_free(s)) free.push_back(s);
      }
    }
  }

 private:
  double alpha(int level) const { return ladder_.is_last(level) ? alpha_ : ladder_.radius(level).value(); }

  /// The first level after this one on which something can happen, or the last.
  int next_level(int level, const std::vector<meshops::Site>& carried) const {
    int next = policy_.next();
    for (const meshops::Site s : carried) next = std::min(next, seeds_.wake(s));
    return std::clamp(next, level + 1, ladder_.end());
  }

  std::span<const std::uint32_t> input_index_;
  const std::function<void(const EndedLevel&)>& level_ended_;
  double alpha_;  // as given: a radius beyond all circumradii is infinite to the ladder
  Ladder<Real> ladder_;
  Pivot<Real> pivot_;
  Apexes<Real> apexes_;
  LevelSeeds<Real> seeds_;
  Report report_;
  LevelPivoting<Real, Report> policy_;
};

}  // namespace

Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options) {
  meshops::require(options.leaf_capacity > 0, "hrbpa: leaf_capacity is 0, expected at least 1");
  check(points, alpha);
  Hierarchy result;
  with_arithmetic_for(points, alpha, [&]<typename Real>(Radius radius, Real grid_unit, double below_all) {
    Assembly<Real> assembly(points, result.complex);
    const auto& grid = assembly.grid();
    if (!are_collinear(grid.points())) {
      const Real side = Quadtree<Real>(grid.points(), options.leaf_capacity).smallest_side();
      result.least_radius =
          std::clamp(static_cast<double>(side / 2), std::max(below_all, std::numeric_limits<double>::denorm_min()),
                     std::numeric_limits<double>::max());
      HierarchicalRun<Real> run(grid, result.least_radius, alpha, radius, grid_unit, options);
      run.advance(assembly.front(), result);
    }
    assembly.finish();
  });
  return result;
}

std::size_t level_of(const Hierarchy& hierarchy, std::size_t face) {
  return static_cast<std::size_t>(std::upper_bound(hierarchy.levels.begin(), hierarchy.levels.end(), face,
                                                   [](std::size_t f, const Level& l) { return f < l.triangles; }) -
                                  hierarchy.levels.begin());
}

}  // namespace rbpa
