#include "rbpa/rbpa.h"

#include <numeric>
#include <utility>

#include "meshops/front/engine.h"
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

/// Tiles tell what they can, and the remainder what is missing.
meshops::AssembledPatches by_tiles(const Sites& sites, const Radius& radius, meshops::PatchAssembler assembler,
                                   Threads& threads, Report& report) {
  Remainder remainder(sites, radius);
  lay_tiles(sites, sites.window().scaled(radius), assembler, threads, [&](const TileTriangles& tile) {
    remainder.add(tile);
    report.worked(assembler.faces());
  });
  meshops::Patch missing;
  meshops::Outline outline;
  remainder.complete(missing, outline, threads, [&] { report.worked(assembler.faces()); });
  assembler.lay(missing, outline);
  auto assembled = std::move(assembler).join();
  report.completed(assembled.mesh());
  return assembled;
}

/// The paper's search, on a grid of its own.
void by_the_paper(const Sites& sites, const Radius& radius, Assembly& assembly, Threads& threads, Report& report) {
  using Real = long double;
  const std::vector<Point> points = sites.points();
  std::vector<std::uint32_t> names(points.size());
  std::iota(names.begin(), names.end(), 0U);
  const PointGrid<Real> grid(NamedPoints{points, names.data()}, threads);
  const Pivot<Real> pivot(grid, radius, 0);
  const PaperPivot<Real> paper_pivot(grid.points(), grid.diameter_bound(), radius, 0);
  Seeds<Real> seeds(grid, radius, pivot);
  RestrictedBallPivoting policy(seeds, paper_pivot, report);
  meshops::Front front = assembly.front();
  meshops::advance(front, policy, report);
  assembly.finish(front, grid.input_index());
}

}  // namespace

SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options) {
  check(points, alpha);
  SolidAlphaComplex complex;
  Threads threads = threads_for(points.size(), options.threads);
  Assembly assembly(points, complex, threads);
  const Sites& sites = assembly.sites();
  Report report(options.progress, sites.size());
  if (assembly.are_collinear())
    assembly.finish(assembly.front());
  else if (options.search == Search::near_to_far)
    assembly.finish(by_tiles(sites, Radius::of(alpha), assembly.assembler(), threads, report));
  else
    by_the_paper(sites, Radius::of(alpha), assembly, threads, report);
  return complex;
}

unsigned threads_used(std::size_t points, unsigned wanted) {
  return static_cast<unsigned>(threads_for(points, wanted).count());
}

}  // namespace rbpa
