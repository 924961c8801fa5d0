// What:   in which triangle of a Delaunay triangulation does a point lie? And what are values between its points?
// Law:    exact, and a function of the point and the triangulation: where the point is on a common side or corner of
//         several triangles, the first of them.
// How:    a walk from triangle to triangle toward the point, from a triangle near the grid cell that contains the point. Such
//         a walk ends in every Delaunay triangulation.
// Cost:   of a Locator linear in the points, some 30 bytes each; of a query a few steps, wherever the points are dense.
// Source: Devillers, Pion, Teillaud, Walking in a triangulation (2002); R. Sibson, A vector identity for the Dirichlet
//         tessellation (1980).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

struct LocateOptions {
  /// Threads that work at most, the calling one included. 0 = all processors; larger values are capped.
  unsigned threads = 0;
  /// Called every few milliseconds, one call at a time but from any thread; returning false ends the work. Empty: never.
  std::function<bool()> go_on = {};
};

/// How values between points come from those of the points. Both keep linear functions, and are continuous.
enum class Interpolation {
  linear,           ///< linear in each triangle
  natural_neighbor  ///< Sibson's: also smooth but at the points, and no triangle shows. See Locator::interpolate().
};

struct InterpolateOptions {
  Interpolation method = Interpolation::linear;
  unsigned threads = 0;              ///< as in LocateOptions
  std::function<bool()> go_on = {};  ///< as in LocateOptions
};

class RBPA_API Locator {
 public:
  /// Keeps the spans.
  /// Requires: finite points and all triangles of their Delaunay triangulation, as triangulate() gives them for an infinite
  ///           alpha with neighbors.
  /// Throws:   ContractViolation as require_linked(), or when they are visibly not; Cancelled.
  Locator(std::span<const Point> points, const TriangleArrays& delaunay, const LocateOptions& options = {});
  Locator(Locator&&) noexcept;
  Locator& operator=(Locator&&) noexcept;
  ~Locator();

  /// For each query, the triangle that contains it, sides and corners included, or TriangleArrays::none; none for a query
  /// that is not finite.
  /// Throws: Cancelled; ContractViolation when a walk shows that the triangulation is not Delaunay.
  std::vector<std::uint32_t> find(std::span<const Point> queries, const LocateOptions& options = {}) const;

  /// Values at queries: of each as many as a point has, row by row. NaN where find() finds no triangle. Of equal points the first
  /// counts.
  ///
  /// By natural neighbors the value is a mean over the points whose Voronoi cells the query would take area from, were it a
  /// point: by these areas. On the convex hull it is linear.
  ///
  /// Error:  a convex combination of the values at the corners or neighbors, but for a few roundings; at a point it is the point's
  ///         own value, to the last bit. Natural neighbors are exact, and their areas right to about
  ///         1e-9 of their sum.
  /// Cost:   of a query that of find(); by natural neighbors also of some ten comparisons with circles and as many
  ///         centers; milliseconds where coordinates are a hundred decades apart.
  /// Throws: InvalidInput when `values` does not have `columns` > 0 numbers for each point; as find().
  std::vector<double> interpolate(std::span<const double> values, std::size_t columns, std::span<const Point> queries,
                                  const InterpolateOptions& options = {}) const;

 private:
  class Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace rbpa
