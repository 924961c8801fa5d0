// What:   the order in which points are inserted: rounds of random points, each eight times the one before, along a Hilbert curve.
// Why:    randomness keeps the number of tetrahedra that are made small on any input, rounds keep the walk from one point to the
//         next short, and the curve keeps what is needed in the caches.
// Law:    a function of the set of points. Each distinct point comes once, as its lowest index.
// Cost:   a sort; more only where clusters are finer than the curve's cells, which get a curve of their own.
// Source: Amenta, Choi, Rote, Incremental constructions con BRIO (2003).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/duplicate.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa::space {

/// All points along the Hilbert curve; equal ones follow each other, the lowest index first.
/// Requires: finite points; the same points scaled, whose differences do not overflow: near enough to lie in the same cells, as
/// nothing but the order of points near each other depends on the cells. Calls `ask`, if any, now and then; it may throw.
std::vector<std::uint32_t> order_on_curve(std::span<const Point3> points, std::span<const Point3> scaled,
                                          const std::function<void()>& ask);

struct SpatialOrder {
  std::vector<std::uint32_t> order;   ///< indices of the distinct points
  std::vector<Duplicate> duplicates;  ///< the other points, ascending by index
};

/// Requires and calls `ask` as order_on_curve().
SpatialOrder spatial_order(std::span<const Point3> points, std::span<const Point3> scaled,
                           const std::function<void()>& ask);

}  // namespace rbpa::space
