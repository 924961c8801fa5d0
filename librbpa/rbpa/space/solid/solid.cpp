#include "rbpa/space/solid/solid.h"

#include <atomic>
#include <cmath>
#include <functional>
#include <utility>

#include "rbpa/base/arrays/distinct.h"
#include "rbpa/base/error.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/space/cells/cells.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/cells/scaled_points.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/solid/insertion/insertion.h"
#include "rbpa/space/solid/insertion/spatial_order.h"
#include "rbpa/space/solid/rows/inserted_rows.h"
#include "rbpa/space/solid/rows/solid_rows.h"
#include "rbpa/space/solid/tiles/find_by_tiles.h"
#include "rbpa/space/solid/triples/find_by_triples.h"
#include "rbpa/space/solid/triples/link_faces.h"

namespace rbpa {
namespace {

/// Finds the tetrahedra from triples of points. Suited to an alpha up to about the spacing and few cospherical points:
///   1. sort the points into cells, and estimate the cost;
///   2. find the tetrahedra of each part of the cells, in any thread, and append the tetrahedra in the order of parts;
///   3. find neighbors, and sort.
/// Returns false, and fills in nothing, if alpha is infinite, points are few or cannot be scaled, the estimated cost of
/// a point is above `most_cost` in units of triples_cost(), or find_by_triples() gives up.
bool find_near(std::span<const Point3> points, double alpha, double most_cost, const SolidOptions& options,
               Solid& solid) {
  constexpr double most_exact = 1.0 / 64;  // exact decisions a point, at most
  constexpr std::size_t sites_in_part = 1u << 12, fewest = 64;
  if (std::isinf(alpha) || points.size() < fewest) return false;
  Threads threads = threads_for(points.size(), options.threads);
  const space::ScaledPoints scaled(points, alpha);
  if (!scaled.fits_double()) return false;
  const space::Cells cells(scaled.points(), 2 * scaled.radius(), threads);
  const std::size_t sites = cells.sites().size();
  if (space::triples_cost(cells) > most_cost * static_cast<double>(sites)) return false;

  std::vector<std::size_t> part_begin;  // first cell of each part
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    if (part_begin.empty() || cells.first_in(cell) - cells.first_in(part_begin.back()) >= sites_in_part)
      part_begin.push_back(cell);
  const std::size_t parts = part_begin.size();
  part_begin.push_back(cells.size());
  struct Workspace {
    space::Triples found;
  };
  space::SolidRows rows;
  std::atomic<bool> gave_up = false;
  in_order<Workspace>(
      threads, parts,
      [&](std::size_t part, Workspace& w) {
        const std::size_t begin = part_begin[part], end = part_begin[part + 1];
        const auto exact =
            fewest + static_cast<std::size_t>(most_exact * (cells.first_in(end) - cells.first_in(begin)));
        if (!gave_up && !space::find_by_triples(cells, scaled.radius(), begin, end, exact, w.found)) gave_up = true;
      },
      [&](std::size_t part, Workspace& w) {
        if (gave_up) return;
        space::check_number_of(rows.corners.size() + w.found.tetrahedra.size());
        rows.corners.insert(rows.corners.end(), w.found.tetrahedra.begin(), w.found.tetrahedra.end());
        stop_if_cancelled(options.progress, {cells.first_in(part_begin[part + 1]), sites});
      },
      [](std::size_t, Workspace&) {});
  if (gave_up) return false;
  if (options.neighbors) rows.neighbors = space::link_faces(rows.corners, sites, threads);
  space::fill_in(std::move(rows), cells.input_index(), points.size(), options.neighbors, threads,
                 checkpoint_of(options.progress, sites, sites), solid);
  solid.distinct = sites;
  solid.duplicates = cells.duplicates();
  return true;
}

void list_isolated(std::size_t points, double alpha, Solid& solid) {
  if (std::isinf(alpha) && !solid.simplices.empty()) return;
  std::vector<bool> is_corner(points, false);
  for (const Row& row : solid.simplices)
    for (const std::uint32_t corner : row) is_corner[corner] = true;
  for_each_distinct(points, solid.duplicates, [&](std::uint32_t i) {
    if (!is_corner[i]) solid.isolated.push_back(i);
  });
}

/// Finds the tetrahedra tile by tile; suited to points that fill a volume. Returns false, and fills in nothing, if
/// scaling is not exact or find_by_tiles() gives up.
bool find_in_tiles(std::span<const Point3> points, double alpha, const SolidOptions& options, Solid& solid) {
  const space::Spread spread = space::spread(points);
  const double scaled_alpha = std::ldexp(alpha, spread.exponent);
  if (!spread.is_exact || (std::isinf(alpha) ? false : !std::isnormal(scaled_alpha))) return false;
  std::vector<Point3> copy;
  const auto scaled = space::scaled(points, spread, copy);
  Threads threads = threads_for(points.size(), options.threads);
  std::function<void(std::size_t, std::size_t)> step;
  if (options.progress)
    step = [&](std::size_t done, std::size_t all) { stop_if_cancelled(options.progress, {done, all}); };
  space::TiledSolid found;
  if (!space::find_by_tiles(scaled, spread, scaled_alpha, threads, step, found)) return false;
  space::fill_in(std::move(found.rows), found.index, points.size(), options.neighbors, threads,
                 checkpoint_of(options.progress, found.distinct, found.distinct), solid);
  solid.distinct = found.distinct;
  solid.duplicates = std::move(found.duplicates);
  return true;
}

/// Finds the tetrahedra in the triangulation of all points. Finds none if all points are in one plane:
///   1. scale the points by a power of two, and sort the points;
///   2. insert the points one by one;
///   3. select and number the tetrahedra of circumradius at most alpha.
void insert_all(std::span<const Point3> points, double alpha, const SolidOptions& options, const Checkpoint& checkpoint,
                Solid& solid) {
  const space::Spread spread = space::spread(points);
  std::vector<Point3> copy;
  const auto scaled = space::scaled(points, spread, copy);
  Threads threads = threads_for(points.size(), options.threads);
  space::SpatialOrder sorted = space::spatial_order(points, scaled, threads, checkpoint);

  solid.distinct = sorted.order.size();
  solid.duplicates = std::move(sorted.duplicates);
  space::Insertion triangulation(points, scaled, spread, sorted, threads);
  sorted = {};
  if (!triangulation.insert_all(options.progress)) return;
  const double scaled_alpha = std::ldexp(alpha, spread.exponent);
  const auto is_kept = [&](std::uint32_t t) {
    return std::isinf(alpha) || triangulation.is_within(t, alpha, scaled_alpha);
  };
  space::fill_in(space::rows_of(triangulation, options.neighbors, threads, is_kept), triangulation.index(),
                 points.size(), options.neighbors, threads,
                 checkpoint_of(options.progress, solid.distinct, solid.distinct), solid);
}

}  // namespace

Solid solid(std::span<const Point3> points, double alpha, const SolidOptions& given) {
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  space::check_points(points);
  const OnProgress progress = rising(given.progress);  // a method may give up, and another one then begins from 0
  SolidOptions options = given;
  if (progress) options.progress = [&](const Progress& now) { return progress(now); };
  const auto checkpoint = checkpoint_of(options.progress, points.size());
  if (checkpoint) checkpoint();
  Solid solid;
  // Costs of a point in units of triples_cost(), fitted to uniform points.
  constexpr double by_insertion = 1500, by_tiles = 800;
  constexpr std::size_t fewest_for_tiles = 20'000;  // with fewer points, too many are at the hull
  const auto by_triples = [&](double most_cost) { return find_near(points, alpha, most_cost, options, solid); };
  const bool is_found =
      points.size() < fewest_for_tiles
          ? by_triples(by_insertion)
          : by_triples(by_tiles) || find_in_tiles(points, alpha, options, solid) || by_triples(by_insertion);
  if (!is_found) insert_all(points, alpha, options, checkpoint, solid);
  list_isolated(points.size(), alpha, solid);
  return solid;
}

}  // namespace rbpa
