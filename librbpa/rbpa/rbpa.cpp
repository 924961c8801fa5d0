#include "rbpa/rbpa.h"

#include <type_traits>

#include "meshops/front/engine.h"
#include "rbpa/collinear.h"
#include "rbpa/parallel/threads.h"
#include "rbpa/pivot/paper_pivot.h"
#include "rbpa/pivot/pivot.h"
#include "rbpa/policy.h"
#include "rbpa/remainder/remainder.h"
#include "rbpa/run/assembly.h"
#include "rbpa/run/input.h"
#include "rbpa/seed/seeds.h"
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

  void near_to_far(meshops::Front& front) {
    if constexpr (std::is_same_v<Real, double>) {
      by_tiles(front);
    } else {
      // Extreme exponents do without tiles.
      const Pivot<Real> pivot(grid_, radius_, grid_unit_);
      advance(front, pivot);
    }
  }

  void by_the_paper(meshops::Front& front) {
    const PaperPivot<Real> pivot(grid_.points(), grid_.diameter_bound(), radius_, grid_unit_);
    advance(front, pivot);
  }

 private:
  void by_tiles(meshops::Front& front) {
    Remainder remainder(grid_.points(), radius_);
    lay_tiles(grid_, radius_, front, threads_, [&](const TileTriangles& tile) {
      remainder.add(tile);
      report_.worked(front);
    });
    meshops::Patch missing;
    meshops::Outline outline;
    remainder.complete(missing, outline, threads_, [&] { report_.worked(front); });
    front.lay(missing, outline);
    report_.worked(front);
    front.join();
    report_.completed(front);
  }

  template <typename FrontPivot>
  void advance(meshops::Front& front, const FrontPivot& front_pivot) {
    const Pivot<Real> pivot(grid_, radius_, grid_unit_);
    Seeds<Real> seeds(grid_, radius_, pivot);
    RestrictedBallPivoting policy(seeds, front_pivot, report_);
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
    Assembly<Real> assembly(points, complex, threads, options.progress);
    if (!are_collinear(assembly.grid().points())) {
      Run<Real> run(assembly.grid(), radius, grid_unit, options, threads);
      if (options.search == Search::near_to_far)
        run.near_to_far(assembly.front());
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
