// What:   computes the order in which points are inserted: rounds of random points, each eight times as large as the
//         round before and sorted along a Hilbert curve.
// Why:    randomness keeps the number of tetrahedra that are made small on any input; rounds keep the walk from one
//         point to the next short; the curve keeps the memory in use in the caches.
// Law:    a function of the set of points. Each distinct point comes once, with its lowest index.
// Cost:   a sort; more only where clusters are finer than the cells of the curve: these get a curve of their own.
// Source: Amenta, Choi, Rote, Incremental constructions con BRIO (2003).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/duplicate.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa::space {

/// Returns the indices of all points in the order of the Hilbert curve; equal points follow each other, the lowest
/// index first. Calls `checkpoint`, if any, repeatedly; it may throw.
/// Requires: finite points; `scaled` has the points times a factor such that differences do not overflow. Rounding in
///           `scaled` affects only the order of points near each other.
std::vector<std::uint32_t> order_on_curve(std::span<const Point3> points, std::span<const Point3> scaled,
                                          const Checkpoint& checkpoint);

struct SpatialOrder {
  std::vector<std::uint32_t> order;   ///< indices of the distinct points
  std::vector<Duplicate> duplicates;  ///< the other points, ascending by index
};

/// Returns the insertion order. Requirements and calls of `checkpoint` are those of order_on_curve().
SpatialOrder spatial_order(std::span<const Point3> points, std::span<const Point3> scaled,
                           const Checkpoint& checkpoint);

}  // namespace rbpa::space
