#include "rbpa/solid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <utility>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/distinct.h"
#include "rbpa/base/error.h"
#include "rbpa/base/input.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/base/steps.h"
#include "rbpa/space/cells/cells.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/cells/scaled_points.h"
#include "rbpa/space/insertion/insertion.h"
#include "rbpa/space/insertion/spatial_order.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/triples/find_by_triples.h"
#include "rbpa/space/triples/link_faces.h"

namespace rbpa {
namespace {

/// An even permutation of four numbers that puts the two least first: two bits for each place.
using Permutation = std::uint8_t;

/// Of twelve, the one for the least at i and the next at j.
constexpr std::array<Permutation, 16> even_permutations() {
  std::array<Permutation, 16> all{};
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned j = 0; j < 4; ++j) {
      if (i == j) continue;
      unsigned k = 0;
      while (k == i || k == j) ++k;
      unsigned l = 6 - i - j - k;
      const auto inversions = [&] { return (i > j) + (i > k) + (i > l) + (j > k) + (j > l) + (k > l); };
      if (inversions() % 2 != 0) std::swap(k, l);
      all[4 * i + j] = static_cast<Permutation>(i | j << 2U | k << 4U | l << 6U);
    }
  return all;
}

/// Which are the two least cannot be predicted, so that nothing branches.
Permutation two_least_first(const Row& row) {
  static constexpr auto all = even_permutations();
  // Each number beside its place.
  const auto placed = [&](std::size_t i) { return std::uint64_t{row[i]} << 2U | i; };
  const std::uint64_t a = placed(0), b = placed(1), c = placed(2), d = placed(3);
  const std::uint64_t low = std::min(a, b), high = std::max(a, b), other_low = std::min(c, d),
                      other_high = std::max(c, d);
  const std::uint64_t least = std::min(low, other_low);
  const std::uint64_t next = std::min(std::max(low, other_low), std::min(high, other_high));
  return all[4 * (least & 3U) + (next & 3U)];
}

template <typename Value>
std::array<Value, 4> permuted(const std::array<Value, 4>& row, Permutation p) {
  return {row[p & 3U], row[p >> 2U & 3U], row[p >> 4U & 3U], row[p >> 6U]};
}

/// The tetrahedra of circumradius at most alpha as rows of input indices, in canonical order, and their neighbours.
void fill_in(const space::Insertion& triangulation, double alpha, double scaled_alpha, std::size_t points,
             const SolidOptions& options, Solid& solid) {
  Threads threads = threads_for(points, options.threads);
  const auto tetrahedra = triangulation.tetrahedra();
  std::vector<std::uint32_t> kept;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
    if (!triangulation.is_deleted(t) && !tetrahedra[t].is_ghost() &&
        (std::isinf(alpha) || triangulation.is_within(t, alpha, scaled_alpha)))
      kept.push_back(t);

  const auto corners_of = [&](std::uint32_t t) {
    const auto& corner = tetrahedra[t].corner;
    return Row{triangulation.index_of(corner[0]), triangulation.index_of(corner[1]), triangulation.index_of(corner[2]),
               triangulation.index_of(corner[3])};
  };
  meshops::FreshVector<Permutation> permutation(kept.size());
  solid.simplices.resize(kept.size());
  constexpr std::size_t at_a_time = 1u << 14;
  for_each_part(threads, kept.size(), at_a_time, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const Row row = corners_of(kept[i]);
      permutation[i] = two_least_first(row);
      solid.simplices[i] = permuted(row, permutation[i]);
    }
  });
  const meshops::FreshVector<std::uint32_t> from = sort_rows(solid.simplices, points, threads);
  if (!options.neighbors) return;
  meshops::FreshVector<std::uint32_t> number(tetrahedra.size());
  for_each_part(threads, number.size(), 1u << 16, [&](std::size_t first, std::size_t last) {
    std::fill(&number[first], &number[0] + last, Solid::none);
  });
  for_each_part(threads, from.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) number[kept[from[i]]] = static_cast<std::uint32_t>(i);
  });
  solid.neighbors.resize(kept.size());
  // In the order of the tetrahedra, whose neighbours are near each other.
  for_each_part(threads, kept.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Row row = permuted(tetrahedra[kept[i]].neighbor, permutation[i]);
      for (std::uint32_t& face : row) face = number[face / 4];
      solid.neighbors[number[kept[i]]] = row;
    }
  });
}

/// Finds them from triples of points, where alpha is about the spacing at most and few points are cospherical. In order:
///   1. sort the points into cells, and estimate what it would cost;
///   2. find the tetrahedra of a part of the cells, in any thread, and append them;
///   3. sort them, and look up neighbours.
/// Returns: false if insertion will be faster; then nothing is filled in.
bool find_near(std::span<const Point3> points, double alpha, const SolidOptions& options, Solid& solid) {
  constexpr double insertion_cost =
      1500;  // of a point, in the unit of triples_cost(): fitted to uniform points, as that is
  constexpr double most_exact = 1.0 / 64;  // a share of the points
  constexpr std::size_t sites_in_part = 1u << 12, fewest = 64;
  if (std::isinf(alpha) || points.size() < fewest) return false;
  Threads threads = threads_for(points.size(), options.threads);
  const space::ScaledPoints scaled(points, alpha);
  if (!scaled.fits_double()) return false;
  const space::Cells cells(scaled.points(), 2 * scaled.radius(), threads);
  const std::size_t sites = cells.sites().size();
  if (space::triples_cost(cells) > insertion_cost * static_cast<double>(sites)) return false;

  std::vector<std::size_t> part_begin;  // by cells
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    if (part_begin.empty() || cells.first_in(cell) - cells.first_in(part_begin.back()) >= sites_in_part)
      part_begin.push_back(cell);
  const std::size_t parts = part_begin.size();
  part_begin.push_back(cells.size());
  struct Workspace {
    space::Triples found;
  };
  std::atomic<bool> gave_up = false;
  const auto index = cells.input_index();
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
        for (const auto& [a, b, c, d] : w.found.tetrahedra) {
          const Row row = {index[a], index[b], index[c], index[d]};
          solid.simplices.push_back(permuted(row, two_least_first(row)));
        }
        if (options.progress && !options.progress({cells.first_in(part_begin[part + 1]), sites})) throw Cancelled();
      },
      [](std::size_t, Workspace&) {});
  if (gave_up) {
    solid.simplices.clear();
    return false;
  }
  sort_rows(solid.simplices, points.size(), threads);
  if (options.neighbors) solid.neighbors = space::link_faces(solid.simplices, points.size(), threads);
  solid.distinct = sites;
  solid.duplicates = cells.duplicates();
  return true;
}

void list_isolated(std::size_t points, Solid& solid) {
  std::vector<bool> is_corner(points, false);
  for (const Row& row : solid.simplices)
    for (const std::uint32_t corner : row) is_corner[corner] = true;
  for_each_distinct(points, solid.duplicates, [&](std::uint32_t i) {
    if (!is_corner[i]) solid.isolated.push_back(i);
  });
}

/// Finds them in the triangulation of all points. In order:
///   1. scale the points by a power of two, and sort them;
///   2. insert them, one by one;
///   3. select the tetrahedra of circumradius at most alpha, and number them.
void insert_all(std::span<const Point3> points, double alpha, const SolidOptions& options,
                const std::function<void()>& ask, Solid& solid) {
  const space::Spread spread = space::spread(points);
  std::vector<Point3> copy;
  const auto scaled = space::scaled(points, spread, copy);
  space::SpatialOrder sorted = space::spatial_order(points, scaled, ask);

  solid.distinct = sorted.order.size();
  solid.duplicates = std::move(sorted.duplicates);
  space::Insertion triangulation(points, scaled, spread, sorted.order);
  if (triangulation.begin()) {
    space::Vertex v = 4;
    const std::function<bool()> go_on = [&] { return !options.progress || options.progress({v, solid.distinct}); };
    Steps step(go_on);
    while (v++ < triangulation.size()) step(triangulation.insert(v));
    fill_in(triangulation, alpha, std::ldexp(alpha, spread.exponent), points.size(), options, solid);
  }
}

}  // namespace

Solid solid(std::span<const Point3> points, double alpha, const SolidOptions& options) {
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  space::check_points(points);
  const auto ask = asking(options.progress, points.size());
  if (ask) ask();
  Solid solid;
  if (!find_near(points, alpha, options, solid)) insert_all(points, alpha, options, ask, solid);
  list_isolated(points.size(), solid);
  return solid;
}

}  // namespace rbpa
