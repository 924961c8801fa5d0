// What: polygons whose corners carry coordinates and 64-bit indices, for an input that is not in memory.
// Law:  those of polygons() (rbpa/shape.h), to the last bit.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"

namespace rbpa {

/// A point of the input by its place there, and where it is. Of equal points the lowest.
struct Corner {
  std::uint64_t index = 0;
  Point at = {};
  friend bool operator==(const Corner&, const Corner&) = default;
};

/// As Ring (rbpa/shape.h): the lexicographically least point first and not repeated, none passed twice.
using CornerRing = std::vector<Corner>;

/// Identifies an unfinished component: one of its triangles, which no other component ever has.
using ComponentName = std::array<std::uint64_t, 3>;

/// As Polygon (rbpa/shape.h), to the last bit.
struct CornerPolygon {
  CornerRing shell = {};               ///< counter-clockwise
  std::vector<CornerRing> holes = {};  ///< clockwise; by first point, then by second
  double area = 0;                     ///< the real number rounded once
  double perimeter = 0;
  /// Input points in it, repetitions counted; one in which several polygons touch counts in the first of them.
  std::uint64_t points = 0;
  /// The holes that take_holes() removed before the polygon was finished: their number, and the names under which they were
  /// returned, ascending. Area and perimeter include them.
  std::uint64_t taken_holes = 0;
  std::vector<ComponentName> names = {};
  friend bool operator==(const CornerPolygon&, const CornerPolygon&) = default;
};

/// The order of polygons: by the first point of the shell, then by the second.
RBPA_API bool comes_before(const CornerPolygon& a, const CornerPolygon& b);

}  // namespace rbpa
