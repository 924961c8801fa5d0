// What:   finds the triangle of a triangulation that contains a point, and interpolates values between points.
// Law:    the triangle is found exactly, as a function of the point and the triangulation: of several triangles that
//         share the side or corner on which the point lies, the one of lowest index is found.
// How:    a walk from triangle to triangle toward the point, from the triangle of the query before, or from one near
//         the grid cell of the point. The walk ends in every Delaunay triangulation, and in a constrained one because
//         a long walk chooses its sides at random.
// Cost:   constructing a Locator takes linear time and some 30 bytes for each point; a query takes a few steps of the
//         walk where points are dense.
// Source: Devillers, Pion, Teillaud, Walking in a triangulation (2002); R. Sibson, A vector identity for the Dirichlet
//         tessellation (1980).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/temporary.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

struct LocateOptions {
  MaxThreads threads = 0;  ///< maximum number; 0: all processors
  GoOn go_on = {};         ///< callback for cancellation, called by find() and interpolate() after each 4,096 queries
};

/// The method of interpolation between points. Both methods reproduce linear functions, and are continuous.
enum class Interpolation {
  linear,  ///< linear in each triangle
  /// Sibson's method: smooth except at the points, so sides of triangles are not visible; see Locator::interpolate().
  natural_neighbor
};

struct InterpolateOptions {
  Interpolation method = Interpolation::linear;
  MaxThreads threads = 0;  ///< maximum number; 0: all processors
  GoOn go_on = {};         ///< as in LocateOptions
  /// There are values only in the triangles of circumradius ≤ alpha, sides included: those of the alpha complex.
  double alpha = std::numeric_limits<double>::infinity();
};

/// A Delaunay triangulation that is prepared for queries. Several threads may query it at the same time.
class RBPA_API Locator {
 public:
  /// Prepares queries in a triangulation. Keeps the spans: points and triangulation must outlive the object and stay
  /// unchanged.
  /// Requires: finite points and all triangles of their Delaunay triangulation, as alpha_complex() returns them for an
  ///           infinite alpha with neighbors, or of their constrained one (constrained_delaunay.h). Whether the
  ///           triangles are Delaunay is not checked.
  /// Throws:   InvalidInput when a point is not finite, or there are more than 357,913,941 points; ContractViolation as
  ///           require_linked(), or when there are triangles, but not as many as a triangulation of all points has;
  ///           Cancelled.
  Locator(std::span<const Point> points, const TriangleArrays& delaunay, const LocateOptions& options = {});
  // The spans would outlive the points, or the triangulation.
  template <TemporaryOwner<std::span<const Point>> Points>
  Locator(Points&&, const TriangleArrays&, const LocateOptions& = {}) = delete;
  template <TemporaryOwner<TriangleArrays> Triangulation>
  Locator(std::span<const Point>, Triangulation&&, const LocateOptions& = {}) = delete;
  Locator(Locator&&) noexcept;
  Locator& operator=(Locator&&) noexcept;
  ~Locator();

  /// Returns for each query the index of the triangle that contains it, sides and corners included, or
  /// TriangleArrays::none if the query is in no triangle or not finite.
  /// Throws: Cancelled; ContractViolation when a walk does not end, because triangles overlap.
  std::vector<std::uint32_t> find(std::span<const Point> queries, const LocateOptions& options = {}) const;

  /// Interpolates at each query. `values` is n × columns: a row for each of the n points, in the order of the points.
  /// The result has a row of `columns` numbers for each query, NaNs where no triangle of circumradius ≤ `alpha`
  /// contains the query. Of equal points, the row of the lowest index counts; otherwise, results do not depend on the
  /// order of the points, to the last bit: on a side, a linear value depends on the ends of the side alone.
  ///
  /// Natural neighbors: if the query were inserted as a point, its Voronoi cell would take area from the cells of some
  /// points. The value is the mean over these points, weighted by these areas; on a side of the convex hull, the value
  /// is linear between the ends of the side.
  ///
  /// Error:  the value is a convex combination of the values at the corners or natural neighbors, except for a few
  ///         roundings, and never beyond them; at a point, it is exactly the value of the point. The set of natural
  ///         neighbors is exact; the error of an area is about 1e-9 of the sum of the areas.
  /// Cost:   for a query, that of find(); by natural neighbors also some ten comparisons with circles and as many
  ///         centers; milliseconds where coordinates are a hundred decades apart.
  /// Throws: InvalidInput when `columns` is 0, `values` does not have n × `columns` numbers, `alpha` is not above 0, or
  ///         natural neighbors of a constrained triangulation are requested; the exceptions of find().
  std::vector<double> interpolate(std::span<const double> values, std::size_t columns, std::span<const Point> queries,
                                  const InterpolateOptions& options = {}) const;

 private:
  class Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace rbpa
