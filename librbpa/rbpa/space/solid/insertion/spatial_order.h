// What:   computes the order in which points are inserted: rounds of random points, each about eight times as large as
//         the previous round and sorted along a Hilbert curve.
// Why:    randomness limits the number of tetrahedra made in total on any input, rounds shorten the walks to points,
//         and the curve keeps the memory that is used in the caches.
// Law:    a function of the set of points. Each distinct point occurs once, with its lowest index.
// Cost:   a sort; further sorts only for clusters finer than the cells of the curve, which get a curve of their own.
// Source: Amenta, Choi, Rote, Incremental constructions con BRIO (2003).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/duplicate.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa::space {

/// Returns the indices of all points in the order of the Hilbert curve. Equal points are adjacent, the lowest index
/// first. Calls `checkpoint`, if any, repeatedly, one call at a time; `checkpoint` may throw.
/// Requires: finite points; `scaled` holds the points, each multiplied by the same factor; differences in `scaled` do
///           not overflow. Rounding in `scaled` affects only the order of points near each other.
std::vector<std::uint32_t> order_on_curve(std::span<const Point3> points, std::span<const Point3> scaled,
                                          Threads& threads, const Checkpoint& checkpoint);

struct SpatialOrder {
  std::vector<std::uint32_t> order;   ///< indices of the distinct points
  std::vector<std::uint32_t> place;   ///< for each point of the order, its place on the curve
  std::vector<Duplicate> duplicates;  ///< the points equal to one of lower index; ascending by index
};

/// Returns the insertion order. The requirements, and the calls of `checkpoint`, are those of order_on_curve().
SpatialOrder spatial_order(std::span<const Point3> points, std::span<const Point3> scaled, Threads& threads,
                           const Checkpoint& checkpoint);

}  // namespace rbpa::space
