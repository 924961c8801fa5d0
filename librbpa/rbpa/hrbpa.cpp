#include "rbpa/hrbpa.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>
#include <optional>
#include <type_traits>

#include "meshops/core/contract.h"
#include "meshops/front/engine.h"
#include "rbpa/collinear.h"
#include "rbpa/hierarchy/local_triangles.h"
#include "rbpa/hierarchy/policy.h"
#include "rbpa/hierarchy/quadtree.h"
#include "rbpa/parallel/threads.h"
#include "rbpa/remainder/remainder.h"
#include "rbpa/run/assembly.h"
#include "rbpa/run/input.h"
#include "rbpa/tile/for_each_tile.h"

namespace rbpa {
namespace {

template <typename Real>
class HierarchicalRun {
 public:
  HierarchicalRun(const PointGrid<Real>& grid, double least, double alpha, Radius radius, Real grid_unit,
                  const HierarchyOptions& options, const meshops::Front& front, Threads& threads)
      : grid_(grid),
        level_ended_(options.level_ended),
        alpha_(alpha),
        ladder_(least, radius, grid.diameter_bound()),
        report_(options.progress, grid.points().size()),
        start_(std::chrono::steady_clock::now()),
        local_(local_triangles(front, threads)),
        pivot_(grid, Radius(), grid_unit),
        apexes_(pivot_),
        seeds_(grid, ladder_, pivot_, apexes_),
        policy_(grid, ladder_, apexes_, seeds_, report_) {
    if (!local_) return;
    for (meshops::Site s = 0; s < static_cast<meshops::Site>(front.sites()); ++s) seeds_.leave_out(s);
  }

  /// Fills in the levels.
  void advance(meshops::Front& front, Hierarchy& result) {
    std::vector<Level>& levels = result.levels;
    auto start = start_;
    std::vector<meshops::Site> carried(front.sites()), free;
    std::iota(carried.begin(), carried.end(), 0);
    Level level{.alpha = alpha(0), .transferred = carried.size()};
    for (;; start = std::chrono::steady_clock::now()) {
      level.taking_part = insert_local_triangles(level.number, front);
      free.clear();
      for (const meshops::Site s : carried) {
        if (seeds_.wake(s) > level.number) continue;
        level.taking_part += !has_local_triangle(s, level.number);
        if (front.is_free(s)) free.push_back(s);
      }
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
        if (level_ended_) level_ended_({levels.back(), front, grid_.input_index()});
      }
      if (ladder_.is_last(level.number)) break;

      const meshops::LevelTransfer transfer = front.next_level();
      carried = transfer.carried;
      level = {.alpha = 0,
               .number = next_level(level.number, carried),
               .transferred = carried.size(),
               .advancing = transfer.reactivated,
               .seconds = in_vain ? level.seconds : 0};
      level.alpha = alpha(level.number);
    }
  }

 private:
  /// Extreme exponents do without tiles: there, all is found level by level.
  static constexpr bool has_tiles = std::is_same_v<Real, double>;

  std::optional<LocalTriangles> local_triangles(const meshops::Front& front, Threads& threads) {
    if constexpr (has_tiles) {
      LocalTriangles found(grid_.points(), ladder_);
      const Radius infinite;
      Remainder remainder(grid_.points(), infinite);
      for_each_tile(grid_, infinite, threads, [&](const TileTriangles& tile) {
        found.add(tile.patch);
        remainder.add(tile);
        report_.worked(front);
      });
      meshops::Patch missing;
      remainder.complete(missing, threads, [&] { report_.worked(front); });
      found.add(missing);
      found.sort();
      return found;
    }
    return std::nullopt;
  }

  /// Returns: at how many sites.
  std::size_t insert_local_triangles(int level, meshops::Front& front) {
    if constexpr (has_tiles) return local_->insert(level, front, apexes_, [&] { report_.worked(front); });
    return 0;
  }

  bool has_local_triangle(meshops::Site s, int level) const {
    if constexpr (has_tiles) return local_->has_triangle(s, level);
    return false;
  }

  double alpha(int level) const { return ladder_.is_last(level) ? alpha_ : ladder_.radius(level).value(); }

  /// The first level after this one on which something can happen, or the last.
  int next_level(int level, const std::vector<meshops::Site>& carried) const {
    int next = policy_.next();
    if constexpr (has_tiles) next = std::min(next, local_->next(level + 1));
    for (const meshops::Site s : carried) next = std::min(next, seeds_.wake(s));
    return std::clamp(next, level + 1, ladder_.end());
  }

  const PointGrid<Real>& grid_;
  const std::function<void(const EndedLevel&)>& level_ended_;
  double alpha_;  // as given: a radius beyond all circumradii is infinite to the ladder
  Ladder<Real> ladder_;
  Report report_;
  std::chrono::steady_clock::time_point start_;  // tiles are on the account of the first level
  std::optional<LocalTriangles> local_;
  Pivot<Real> pivot_;
  Apexes<Real> apexes_;
  LevelSeeds<Real> seeds_;
  LevelPivoting<Real, Report> policy_;
};

}  // namespace

Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options) {
  meshops::require(options.leaf_capacity > 0, "hrbpa: leaf_capacity is 0, expected at least 1");
  check(points, alpha);
  Hierarchy result;
  Threads threads = threads_for(points.size(), options.threads);
  const auto run = [&]<typename Real>(Radius radius, Real grid_unit, double below_all) {
    Assembly<Real> assembly(points, result.complex, threads);
    const auto& grid = assembly.grid();
    if (!are_collinear(grid.points())) {
      const Real side = Quadtree<Real>(grid.points(), options.leaf_capacity).smallest_side();
      result.least_radius =
          std::clamp(static_cast<double>(side / 2), std::max(below_all, std::numeric_limits<double>::denorm_min()),
                     std::numeric_limits<double>::max());
      HierarchicalRun<Real>(grid, result.least_radius, alpha, radius, grid_unit, options, assembly.front(), threads)
          .advance(assembly.front(), result);
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
