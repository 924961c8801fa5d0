#include "rbpa/rbpa.h"

#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/front/engine.h"
#include "rbpa/collinear.h"
#include "rbpa/parallel/threads.h"
#include "rbpa/pivot/paper_pivot.h"
#include "rbpa/pivot/remaining_pivot.h"
#include "rbpa/policy.h"
#include "rbpa/run/assembly.h"
#include "rbpa/run/input.h"
#include "rbpa/tile/lay_tiles.h"

namespace rbpa {
namespace {

template <typename Real>
class Run {
 public:
  Run(const PointGrid<Real>& grid, Radius radius, Real grid_unit, const Options& options, Threads& threads)
      : grid_(grid),
        radius_(radius),
        grid_unit_(grid_unit),
        threads_(threads),
        report_(options.progress, grid.points().size()) {}

  void by_tiles(meshops::Front& front) {
    std::vector<bool> known;
    // Extreme exponents do without tiles.
    if constexpr (std::is_same_v<Real, double>)
      known = lay_tiles(grid_, radius_, front, threads_, [&] { report_.worked(front); });
    if (radius_.is_infinite() && front.faces() > 0) {
      const RemainingPivot<Real> pivot(grid_, known, grid_unit_);
      NoSeeds seeds;  // the Delaunay triangulation hangs together through edges
      advance(front, pivot, seeds);
    } else {
      const Pivot<Real> pivot(grid_, radius_, grid_unit_);
      Seeds<Real> seeds(grid_, radius_, pivot, std::move(known));
      advance(front, pivot, seeds);
    }
  }

  void by_the_paper(meshops::Front& front) {
    const Pivot<Real> pivot(grid_, radius_, grid_unit_);
    const PaperPivot<Real> paper_pivot(grid_.points(), grid_.diameter_bound(), radius_, grid_unit_);
    Seeds<Real> seeds(grid_, radius_, pivot);
    advance(front, paper_pivot, seeds);
  }

 private:
  template <typename FrontPivot, typename AnySeeds>
  void advance(meshops::Front& front, const FrontPivot& pivot, AnySeeds& seeds) {
    RestrictedBallPivoting policy(seeds, pivot, report_);
    meshops::advance(front, policy, report_);
  }

  const PointGrid<Real>& grid_;
  Radius radius_;
  Real grid_unit_;
  Threads& threads_;
  Report report_;
};

}  // namespace

SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options) {
  check(points, alpha);
  SolidAlphaComplex complex;
  Threads threads = threads_for(points.size(), options.threads);
  with_arithmetic_for(points, alpha, [&]<typename Real>(Radius radius, Real grid_unit, double) {
    Assembly<Real> assembly(points, complex, threads);
    if (!are_collinear(assembly.grid().points())) {
      Run<Real> run(assembly.grid(), radius, grid_unit, options, threads);
      if (options.search == Search::near_to_far)
        run.by_tiles(assembly.front());
      else
        run.by_the_paper(assembly.front());
    }
    assembly.finish();
  });
  return complex;
}

unsigned threads_used(std::size_t points, unsigned wanted) {
  return static_cast<unsigned>(threads_for(points, wanted).count());
}

}  // namespace rbpa
