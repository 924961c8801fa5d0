// What: polygons whose corners carry coordinates and 64-bit indices, for an input that is not in memory.
// Law:  the polygons equal those of outline_polygons() (rbpa/plane/outline_polygons.h), to the last bit.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"

namespace rbpa {

/// An input point: its index and its coordinates. Equal points have the lowest of their indices.
struct Corner {
  std::uint64_t index = 0;
  Point at = {};
  friend bool operator==(const Corner&, const Corner&) = default;
};

/// A Ring (rbpa/plane/outline_polygons.h) with coordinates: begins with its lexicographically least point, which is not
/// repeated; passes no point twice.
using CornerRing = std::vector<Corner>;

/// The name of an unfinished component: one of its triangles, which no other component ever has.
using ComponentName = std::array<std::uint64_t, 3>;

/// A Polygon (rbpa/plane/outline_polygons.h) with coordinates, equal to it to the last bit.
struct CornerPolygon {
  CornerRing shell = {};               ///< counter-clockwise
  std::vector<CornerRing> holes = {};  ///< clockwise; by first point, then by second
  double area = 0;                     ///< the real number rounded once
  double perimeter = 0;
  /// Number of input points in it, duplicates included. A point at which several polygons touch counts in the first of
  /// them.
  std::uint64_t points = 0;
  /// Number of holes that take_holes() removed before the polygon was finished, and the names under which they were
  /// returned, ascending. Area and perimeter include these holes.
  std::uint64_t taken_holes = 0;
  std::vector<ComponentName> names = {};
  friend bool operator==(const CornerPolygon&, const CornerPolygon&) = default;
};

/// Returns whether `a` comes before `b` in the order of polygons: by the first point of the shell, then by the second.
RBPA_API bool comes_before(const CornerPolygon& a, const CornerPolygon& b);

}  // namespace rbpa
