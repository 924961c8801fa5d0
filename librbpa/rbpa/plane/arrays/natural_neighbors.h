// What:   Sibson's coordinates of a point in a Delaunay triangulation: if the point became a site, its Voronoi cell
//         would be cut out of the cells of its natural neighbors; the share of a neighbor is the area that its cell
//         would lose, divided by the area of the new cell.
// Law:    the set of neighbors is exact. Shares are not negative, their sum is 1, and the mean of the neighbors
//         weighted by their shares is the point (Sibson's identity). Shares do not depend on the order of the points.
// How:    the triangles whose circles contain the point form a polygon without points inside. The corners of the
//         polygon are the natural neighbors. A walk goes around the polygon; at each corner it passes the polygon's
//         triangles at this corner. Their circumcenters, and those of the two triangles that the point forms with the
//         sides at the corner, bound the part of the new cell that is cut out of the corner's cell. Areas are computed
//         in double if the result satisfies Sibson's identity to 1e-9, otherwise in twice the precision on the same
//         condition, and otherwise in rational numbers.
// Cost:   linear in the triangles whose circles contain the point: four on average.
// Source: R. Sibson, A vector identity for the Dirichlet tessellation (1980).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// Returns the corners of a triangle in their cyclic order, the lexicographically least point first: an order that does
/// not depend on indices.
inline Triangle least_first(std::span<const Point> points, Triangle of) {
  while (points[of[1]] < points[of[0]] || points[of[2]] < points[of[0]]) of = {of[1], of[2], of[0]};
  return of;
}

struct PointShare {
  std::uint32_t point;
  double share;
};

class NaturalNeighbors {
 public:
  /// Keeps the spans; points, triangles and neighbors must outlive the object.
  NaturalNeighbors(std::span<const Point> points, const TriangleArrays& delaunay) : points_(points), of_(delaunay) {}

  /// Returns the natural neighbors of `query` and their shares; the span is valid until the next call.
  /// Requires: triangle t contains the query, which is not one of its corners and not on the convex hull.
  std::span<const PointShare> find(const Point& query, std::uint32_t t);

 private:
  /// The side of a triangle across from corner `across`.
  struct Side {
    std::uint32_t triangle;
    std::size_t across;
    friend bool operator==(const Side&, const Side&) = default;
  };
  std::uint32_t begin(const Side& s) const { return of_.triangles[s.triangle][(s.across + 1) % 3]; }
  std::uint32_t end(const Side& s) const { return of_.triangles[s.triangle][(s.across + 2) % 3]; }
  /// Returns the side of the same triangle that begins where `s` ends.
  static Side next(const Side& s) { return {s.triangle, (s.across + 1) % 3}; }
  bool goes_on_beyond(const Side& s, const Point& query) const;
  Side beyond(const Side& s) const;
  template <typename Number, typename Visit>
  void measure(const Point& query, const Side& first, int exponent, Visit visit) const;
  template <typename Number>
  bool find_rounded(const Point& query, const Side& first, int exponent);
  void find_exactly(const Point& query, const Side& first);
  /// Calls measure(), and visit(corner, area) for each corner from the lexicographically least on.
  template <typename Number, typename Visit>
  void measure_in_order(const Point& query, const Side& first, int exponent, Visit visit) const;

  std::span<const Point> points_;
  TriangleArrays of_;
  std::vector<PointShare> shares_;
};

}  // namespace rbpa
