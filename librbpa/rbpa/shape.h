// What: the alpha solid as polygons with holes, one for each solid component.
// Law:  valid under OGC Simple Features, one by one and all as a multipolygon; the areas add up to the triangles'.
//       A function of the set of points and alpha: triangles and vertices in any order give the same polygons in the
//       same order.
// Cost: linear in the complex, n log n in the boundary.
// Source: docs/shape.md.
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

struct SolidAlphaComplex;  // rbpa/complex.h

/// A closed polyline that passes no point twice.
struct Ring {
  std::vector<std::uint32_t> points;  ///< input indices, the lexicographically least point first and not repeated
  friend bool operator==(const Ring&, const Ring&) = default;
};

/// A solid component. Its interior is connected; rings touch each other in single points, if at all.
struct Polygon {
  Ring shell = {};  ///< counter-clockwise
  std::vector<Ring> holes =
      {};                ///< clockwise, inside the shell; by first point, then by second, both lexicographically
  double area = 0;       ///< of the shell without the holes: the real number rounded once
  double perimeter = 0;  ///< of all rings, within 4 · 2⁻⁵³ of itself; both are infinite beyond the range of double
  friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// Bounds below which holes and parts are left out, in squared units of the points. Areas are compared as they are rounded.
struct PolygonFilter {
  /// Holes whose ring encloses less are filled, and polygons in them are dropped.
  double min_hole_area = 0;
  /// Polygons of less area, after holes are filled, are dropped.
  double min_part_area = 0;
};

/// The solid components as polygons, sorted by the first point of the shell, then by the second, lexicographically.
/// Where a component touches itself in a point, its boundary is split there into rings. A boundary edge is on exactly
/// one ring, and no other edge is on any.
/// Throws: InvalidInput when a bound of the filter is negative or not a number; Cancelled when `go_on`, which is called
///         every few milliseconds, returns false. Empty: never called.
/// Cost:   as above; each filter for holes adds a plane sweep over the boundary.
RBPA_API std::vector<Polygon> polygons(const SolidAlphaComplex& complex, const PolygonFilter& filter = {},
                                       const std::function<bool()>& go_on = {});

/// The same of a solid complex in arrays, with neighbors, on these points.
/// Throws: moreover ContractViolation as require_linked(), or when the points are visibly others.
RBPA_API std::vector<Polygon> polygons(std::span<const Point> points, const TriangleArrays& complex,
                                       const PolygonFilter& filter = {}, const std::function<bool()>& go_on = {});

struct PolygonTotals {
  std::size_t holes = 0;
  double area = 0;  ///< the exact sum of the polygons' areas, rounded once; so is the perimeter
  double perimeter = 0;
};

RBPA_API PolygonTotals total(std::span<const Polygon> polygons);

/// The same of polygons that are not in memory together.
class RBPA_API RunningTotals {
 public:
  RunningTotals();
  ~RunningTotals();
  RunningTotals(const RunningTotals&) = delete;
  RunningTotals& operator=(const RunningTotals&) = delete;

  /// Requires: an area and a perimeter that are not negative; they may be infinite.
  void add(std::size_t holes, double area, double perimeter);
  PolygonTotals totals() const;

 private:
  struct Sums;
  std::unique_ptr<Sums> sums_;
};

}  // namespace rbpa
