#include "rbpa/rbpa.h"

#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/front/engine.h"
#include "rbpa/collinear.h"
#include "rbpa/pivot/paper_pivot.h"
#include "rbpa/policy.h"
#include "rbpa/run/assembly.h"
#include "rbpa/run/input.h"
#include "rbpa/tile/lay_tiles.h"

namespace rbpa {
namespace {

template <typename Real>
class Run {
 public:
  Run(const PointGrid<Real>& grid, Radius radius, Real grid_unit, const Options& options)
      : grid_(grid), radius_(radius), pivot_(grid, radius, grid_unit), grid_unit_(grid_unit), options_(options) {}

  void advance(meshops::Front& front) const {
    Report report(options_.progress, grid_.points().size());
    if (options_.search == Search::near_to_far) {
      std::vector<bool> known;
      // Extreme exponents do without tiles.
      if constexpr (std::is_same_v<Real, double>)
        known = lay_tiles(grid_, radius_, front, [&] { report.worked(front); });
      advance(front, pivot_, std::move(known), report);
    } else {
      advance(front, PaperPivot<Real>(grid_.points(), grid_.diameter_bound(), radius_, grid_unit_), {}, report);
    }
  }

 private:
  template <typename FrontPivot>
  void advance(meshops::Front& front, const FrontPivot& pivot, std::vector<bool> known, Report& report) const {
    Seeds<Real> seeds(grid_, radius_, pivot_, std::move(known));
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
