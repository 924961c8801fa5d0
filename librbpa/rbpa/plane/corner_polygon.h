// What: holds polygons whose corners carry coordinates and 64-bit indices, for an input that does not fit into memory.
// Law:  the polygons of a whole complex equal those of outline_polygons() (rbpa/plane/outline_polygons.h), to the last
//       bit, except for holes that take_holes() (rbpa/plane/partial.h) removed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"

namespace rbpa {

/// A corner of a polygon: the index of an input point in the whole input, of equal points the lowest, and the
/// coordinates of the point.
struct Corner {
  std::uint64_t index = 0;
  Point at = {};
  friend bool operator==(const Corner&, const Corner&) = default;
};

/// A closed polyline of corners, which begins with its lexicographically least point, passes no point twice, and does
/// not repeat the first point at the end.
using CornerRing = std::vector<Corner>;

/// The name of an unfinished component, which other regions may continue: the input indices of the corners of one of
/// its triangles. No other component ever has this triangle.
using ComponentName = std::array<std::uint64_t, 3>;

/// A solid component as a polygon whose corners carry coordinates.
struct CornerPolygon {
  CornerRing shell = {};               ///< counter-clockwise
  std::vector<CornerRing> holes = {};  ///< clockwise; sorted by first point, then by second, both lexicographically
  double area = 0;                     ///< area of the shell minus that of all holes: the real number rounded once
  double perimeter = 0;                ///< length of all rings, with a relative error of at most 4 · 2⁻⁵³
  /// Number of input points in the triangles of the polygon, duplicates included. A point at which several polygons
  /// touch counts only in the first of them, in the order of comes_before().
  std::uint64_t points = 0;
  /// Number of holes that take_holes() removed before the polygon was finished. `area` and `perimeter` are those of the
  /// polygon with the removed holes.
  std::uint64_t taken_holes = 0;
  std::vector<ComponentName> names = {};  ///< names under which take_holes() returned the removed holes, ascending
  friend bool operator==(const CornerPolygon&, const CornerPolygon&) = default;
};

/// Returns whether `a` comes before `b` in the order of polygons: by the first point of the shell, then by the second,
/// both lexicographically. Requires: shells of at least two points; not checked.
RBPA_API bool comes_before(const CornerPolygon& a, const CornerPolygon& b);

}  // namespace rbpa
