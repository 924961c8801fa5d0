#include "rbpa/solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/distinct.h"
#include "rbpa/base/error.h"
#include "rbpa/base/input.h"
#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/base/steps.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/insertion/insertion.h"
#include "rbpa/space/insertion/spatial_order.h"
#include "rbpa/space/predicate/spread.h"

namespace rbpa {
namespace {

/// Where each corner of a row goes: the two least first, by an even permutation.
std::array<std::uint8_t, 4> canonical_corners(const Row& row) {
  std::array<std::uint8_t, 4> order = {0, 1, 2, 3};
  bool is_odd = false;
  const auto exchange = [&](std::size_t i, std::size_t j) {
    std::swap(order[i], order[j]);
    is_odd = !is_odd;
  };
  for (std::size_t place : {std::size_t{0}, std::size_t{1}})
    for (std::size_t i = place + 1; i < 4; ++i)
      if (row[order[i]] < row[order[place]]) exchange(place, i);
  if (is_odd) exchange(2, 3);
  return order;
}

template <typename Value>
std::array<Value, 4> permuted(const std::array<Value, 4>& row, const std::array<std::uint8_t, 4>& order) {
  return {row[order[0]], row[order[1]], row[order[2]], row[order[3]]};
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
  solid.simplices.resize(kept.size());
  constexpr std::size_t at_a_time = 1u << 14;
  for_each_part(threads, kept.size(), at_a_time, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const Row row = corners_of(kept[i]);
      solid.simplices[i] = permuted(row, canonical_corners(row));
    }
  });
  const meshops::FreshVector<std::uint32_t> from = sort_rows(solid.simplices, points, threads);
  if (!options.neighbors) return;
  std::vector<std::uint32_t> number(tetrahedra.size(), Solid::none);
  for (std::size_t i = 0; i < from.size(); ++i) number[kept[from[i]]] = static_cast<std::uint32_t>(i);
  solid.neighbors.resize(kept.size());
  for_each_part(threads, kept.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t t = kept[from[i]];
      const auto neighbor = permuted(tetrahedra[t].neighbor, canonical_corners(corners_of(t)));
      for (std::size_t k = 0; k < 4; ++k) solid.neighbors[i][k] = number[neighbor[k] / 4];
    }
  });
}

void list_isolated(std::size_t points, Solid& solid) {
  std::vector<bool> is_corner(points, false);
  for (const Row& row : solid.simplices)
    for (const std::uint32_t corner : row) is_corner[corner] = true;
  for_each_distinct(points, solid.duplicates, [&](std::uint32_t i) {
    if (!is_corner[i]) solid.isolated.push_back(i);
  });
}

}  // namespace

/// In order:
///   1. scale the points by a power of two, and sort them;
///   2. insert them, one by one;
///   3. select the tetrahedra of circumradius at most alpha, and number them.
Solid solid(std::span<const Point3> points, double alpha, const SolidOptions& options) {
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  space::check_points(points);
  const auto ask = asking(options.progress, points.size());
  if (ask) ask();
  const space::Spread spread = space::spread(points);
  std::vector<Point3> copy;
  const auto scaled = space::scaled(points, spread, copy);
  space::SpatialOrder sorted = space::spatial_order(points, scaled, ask);

  Solid solid;
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
  list_isolated(points.size(), solid);
  return solid;
}

}  // namespace rbpa
