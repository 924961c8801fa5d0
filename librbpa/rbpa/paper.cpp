#include "rbpa/paper.h"

#include "meshops/core/contract.h"
#include "rbpa/base/run/input.h"
#include "rbpa/paper/growth_of_radii.h"
#include "rbpa/paper/pivoting.h"
#include "rbpa/plane/hierarchy/level_record.h"
#include "rbpa/plane/mesh/assembly.h"

namespace rbpa::paper {

SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options) {
  check(points, alpha);
  SolidAlphaComplex complex;
  Threads one;
  Assembly assembly(points, complex, one, options.progress);
  Monitor monitor(options.progress, assembly.sites().size());
  meshops::Front front = assembly.front();
  if (!assembly.are_collinear(options.progress)) rbpa(assembly.sites().points(), Radius::of(alpha), front, monitor);
  assembly.finish(front);
  return complex;
}

Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options) {
  const std::size_t leaf_capacity = options.leaf_capacity.value_or(usual_leaf_capacity);
  meshops::require(leaf_capacity > 0, "hrbpa: leaf_capacity is 0, expected at least 1");
  check(points, alpha);
  Hierarchy result;
  Threads one;
  Assembly assembly(points, result.complex, one, options.progress);
  const Sites& sites = assembly.sites();
  Monitor monitor(options.progress, sites.size());
  meshops::Front front = assembly.front();
  if (!assembly.are_collinear(options.progress)) {
    LevelRecord record(alpha, options.level_ended, sites.input_index(), result);
    const auto level_ended = [&](const Level& level) {
      record.end({.number = level.number,
                  .transferred = level.transferred,
                  .taking_part = level.transferred,
                  .advancing = level.advancing},
                 level.radius, level.is_last, front);
    };
    result.least_radius = hrbpa(sites.points(), sites.reachable(alpha), leaf_capacity, front, monitor, level_ended);
  }
  assembly.finish(front);
  return result;
}

}  // namespace rbpa::paper
