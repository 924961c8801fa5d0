#include "rbpa/rbpa.h"

#include "meshops/front/engine.h"
#include "rbpa/collinear.h"
#include "rbpa/pivot/paper_pivot.h"
#include "rbpa/policy.h"
#include "rbpa/run/assembly.h"
#include "rbpa/run/input.h"

namespace rbpa {
namespace {

template <typename Real>
class Run {
 public:
  Run(const PointGrid<Real>& grid, Radius radius, Real grid_unit, const Options& options)
      : grid_(grid), radius_(radius), pivot_(grid, radius, grid_unit), grid_unit_(grid_unit), options_(options) {}

  void advance(meshops::Front& front) const {
    if (options_.search == Search::near_to_far)
      advance(front, pivot_);
    else
      advance(front, PaperPivot<Real>(grid_.points(), grid_.diameter_bound(), radius_, grid_unit_));
  }

 private:
  template <typename FrontPivot>
  void advance(meshops::Front& front, const FrontPivot& pivot) const {
    Seeds<Real> seeds(grid_, radius_, pivot_);
    Report report(options_.progress, grid_.points().size());
    RestrictedBallPivoting<Real, FrontPivot, Report> policy(seeds, pivot, report);
    meshops::advance(front, policy, report);
  }

  const PointGrid<Real>& grid_;
  Radius radius_;
  Pivot<Real> pivot_;
  Real grid_unit_;
  const Options& options_;
};

}  // namespace

SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options) {
  check(points, alpha);
  SolidAlphaComplex complex;
  with_arithmetic_for(points, alpha, [&]<typename Real>(Radius radius, Real grid_unit, double) {
    Assembly<Real> assembly(points, complex);
    if (!are_collinear(assembly.grid().points()))
      Run<Real>(assembly.grid(), radius, grid_unit, options).advance(assembly.front());
    assembly.finish();
  });
  return complex;
}

}  // namespace rbpa
