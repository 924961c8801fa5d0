#include "rbpa/space/balls/regular_triangulation.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "rbpa/base/arrays/distinct.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/beside_flat.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/solid/insertion/insertion.h"
#include "rbpa/space/solid/insertion/spatial_order.h"
#include "rbpa/space/solid/rows/inserted_rows.h"
#include "rbpa/space/solid/rows/solid_rows.h"

namespace rbpa {
namespace {

/// Puts the largest ball at each center into `order`, in place of the ball of lowest index. `same_center` has the balls
/// whose center a ball of lower index has, ascending by center. Lists the duplicates and counts distinct balls.
void choose_largest(std::span<const double> radii, std::vector<Duplicate> same_center,
                    std::vector<std::uint32_t>& order, RegularTriangulation& result) {
  result.distinct = order.size();
  if (same_center.empty()) return;
  std::vector<std::uint32_t> largest(radii.size());
  for (const std::uint32_t i : order) {
    largest[i] = i;
    same_center.push_back({i, i});
  }
  std::sort(same_center.begin(), same_center.end(), [&](const Duplicate& d, const Duplicate& e) {
    return std::tuple(d.stands_for, -radii[d.index], d.index) < std::tuple(e.stands_for, -radii[e.index], e.index);
  });
  std::uint32_t first = RegularTriangulation::none, center = first;  // of the balls equal to the current one
  for (const auto& [index, stands_for] : same_center) {
    if (stands_for == center && radii[index] == radii[first]) {
      result.duplicates.push_back({index, first});
      continue;
    }
    if (stands_for != center) largest[stands_for] = index;
    first = index;
    center = stands_for;
  }
  std::sort(result.duplicates.begin(), result.duplicates.end(),
            [](const Duplicate& d, const Duplicate& e) { return d.index < e.index; });
  result.distinct = radii.size() - result.duplicates.size();
  for (std::uint32_t& i : order) i = largest[i];
}

/// Inserts the balls of the order. Calls use(triangulation), and returns true, unless all centers are in one plane.
template <typename Use>
bool triangulate(std::span<const Point3> centers, std::span<const double> radii, const space::SpatialOrder& order,
                 Threads& threads, const OnProgress& progress, Use use) {
  const space::Spread spread = space::spread(centers, radii);
  std::vector<Point3> copy;
  std::vector<double> copy_of_radii;
  space::BallInsertion triangulation(centers, space::scaled(centers, spread, copy), spread, order, threads, radii,
                                     space::scaled(radii, spread, copy_of_radii));
  if (!triangulation.insert_all(progress)) return false;
  use(triangulation);
  return true;
}

/// Returns the triangulation of centers that are all in one plane: RegularTriangulation::flat.
std::vector<Row> triangulate_flat(std::span<const Point3> centers, std::span<const double> radii,
                                  space::SpatialOrder sorted, const OnProgress& progress) {
  std::vector<Point3> with_apexes(centers.begin(), centers.end());
  std::vector<double> their_radii(radii.begin(), radii.end());
  std::vector<Point3> in_order;
  for (const std::uint32_t i : sorted.order) in_order.push_back(centers[i]);
  for (const Point3& apex : space::beside_flat(in_order)) {
    sorted.order.push_back(static_cast<std::uint32_t>(with_apexes.size()));
    with_apexes.push_back(apex);
    their_radii.push_back(0);
  }
  std::vector<Row> flat;
  Threads one(1);
  triangulate(with_apexes, their_radii, sorted, one, progress, [&](space::BallInsertion& triangulation) {
    for (Row row : space::rows_of(triangulation, false, one, [](std::uint32_t) { return true; }).corners) {
      for (std::uint32_t& corner : row) {
        const std::uint32_t index = triangulation.index()[corner];
        corner = index < centers.size() ? index : RegularTriangulation::none;
      }
      std::sort(row.begin(), row.end());
      flat.push_back(row);
    }
  });
  std::sort(flat.begin(), flat.end());
  return flat;
}

/// Lists the distinct balls that are no corner of the triangulation.
void list_hidden(std::size_t balls, RegularTriangulation& result) {
  std::vector<bool> is_corner(balls, false);
  for (const auto* rows : {&result.simplices, &result.flat})
    for (const Row& row : *rows)
      for (const std::uint32_t corner : row)
        if (corner != RegularTriangulation::none) is_corner[corner] = true;
  for_each_distinct(balls, result.duplicates, [&](std::uint32_t i) {
    if (!is_corner[i]) result.hidden.push_back(i);
  });
}

}  // namespace

RegularTriangulation regular_triangulation(std::span<const Point3> centers, std::span<const double> radii,
                                           const SolidOptions& options) {
  space::check_balls(centers, radii);
  RegularTriangulation result;
  Solid solid;
  if (std::equal(radii.begin() + (radii.empty() ? 0 : 1), radii.end(), radii.begin()))
    solid = rbpa::solid(centers, std::numeric_limits<double>::infinity(), options);
  if (!solid.simplices.empty()) {
    result.duplicates = std::move(solid.duplicates);
    result.distinct = solid.distinct;
  } else {
    const auto checkpoint = checkpoint_of(options.progress, centers.size());
    const space::Spread spread = space::spread(centers);
    std::vector<Point3> copy;
    Threads threads = threads_for(centers.size(), options.threads);
    space::SpatialOrder sorted =
        space::spatial_order(centers, space::scaled(centers, spread, copy), threads, checkpoint);
    choose_largest(radii, std::move(sorted.duplicates), sorted.order, result);
    const auto fill_in = [&](space::BallInsertion& triangulation) {
      space::fill_in(space::rows_of(triangulation, options.neighbors, threads, [](std::uint32_t) { return true; }),
                     triangulation.index(), centers.size(), options.neighbors, threads,
                     checkpoint_of(options.progress, sorted.order.size(), sorted.order.size()), solid);
    };
    if (!triangulate(centers, radii, sorted, threads, options.progress, fill_in) && !centers.empty())
      result.flat = triangulate_flat(centers, radii, std::move(sorted), options.progress);
  }
  result.simplices = std::move(solid.simplices);
  result.neighbors = std::move(solid.neighbors);
  list_hidden(centers.size(), result);
  return result;
}

}  // namespace rbpa
