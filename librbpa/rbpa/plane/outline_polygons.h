// What:   computes the solid alpha complex as polygons with holes, one for each solid component.
// Law:    each polygon is valid under OGC Simple Features, and so are all together as a multipolygon. Without a filter,
//         the polygons cover exactly the triangles. Polygons and their order are a function of the set of points, alpha
//         and the filter, not of the order of triangles and vertices.
// Cost:   linear in the complex, n log n in the boundary.
// Source: docs/explanation/plane.md, sections 23 to 25.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/polygon.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

struct SolidAlphaComplex;  // rbpa/plane/complex.h

/// Lower bounds for the areas of holes and polygons, in squared units of the points. Areas are compared as rounded. A
/// bound of 0 removes nothing.
struct PolygonFilter {
  /// Least area of a hole: holes whose ring encloses less are filled, and polygons in filled holes are dropped.
  double min_hole_area = 0;
  /// Least area of a polygon: polygons of less area, after holes are filled, are dropped.
  double min_part_area = 0;
};

/// Returns the solid components as polygons, sorted by the first point of the shell, then by the second,
/// lexicographically. Where a component touches itself at a point, its boundary is split there into rings. Without a
/// filter, each boundary edge is on exactly one ring, and no other edge is on any.
/// Throws: InvalidInput when a bound of the filter is negative or not a number; Cancelled.
/// Cost:   linear in the complex, n log n in the boundary; with a bound on holes also a plane sweep, n log n in the
///         boundary.
RBPA_API std::vector<Polygon> outline_polygons(const SolidAlphaComplex& complex, const PolygonFilter& filter = {},
                                               const GoOn& go_on = {});

/// Returns the outline polygons of a solid complex in arrays, in the same order and at the same cost.
/// Requires: neighbors were computed; triangles are counter-clockwise, and corners are indices of `points`.
/// Throws:   InvalidInput when a bound of the filter is negative or not a number; ContractViolation as
///           require_linked(), or when no ring of a component is counter-clockwise; Cancelled.
RBPA_API std::vector<Polygon> outline_polygons(std::span<const Point> points, const TriangleArrays& complex,
                                               const PolygonFilter& filter = {}, const GoOn& go_on = {});

/// Removes small holes and polygons from `polygons`: the result of outline_polygons() without a filter becomes that
/// with `filter`. The indices of `polygons` are those of `points`, where a point may stand several times.
/// Throws: InvalidInput when a bound of the filter is negative or not a number; Cancelled, after which `polygons` are
///         incomplete.
RBPA_API void filter_polygons(std::vector<Polygon>& polygons, std::span<const Point> points,
                              const PolygonFilter& filter, const GoOn& go_on = {});

/// The number of holes of polygons, and the sums of their areas and perimeters.
struct PolygonTotals {
  std::size_t holes = 0;
  double area = 0;       ///< exact sum of Polygon::area, rounded once; infinite if one area is
  double perimeter = 0;  ///< exact sum of Polygon::perimeter, rounded once; infinite if one perimeter is
};

/// Returns the totals of the polygons, 0 if there are none. Cost: linear in the polygons, not in their corners.
RBPA_API PolygonTotals total(std::span<const Polygon> polygons);

/// A running sum of PolygonTotals over polygons that are not in memory at the same time.
class RBPA_API RunningTotals {
 public:
  RunningTotals();
  ~RunningTotals();
  RunningTotals(const RunningTotals&) = delete;
  RunningTotals& operator=(const RunningTotals&) = delete;

  /// Adds a polygon with this number of holes, area and perimeter.
  /// Requires: an area and a perimeter that are not negative; they may be infinite.
  void add(std::size_t holes, double area, double perimeter);
  PolygonTotals totals() const;  ///< totals of all polygons that were added

 private:
  struct Sums;
  std::unique_ptr<Sums> sums_;
};

}  // namespace rbpa
