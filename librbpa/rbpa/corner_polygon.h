// What: polygons whose corners have coordinates, as the points of the input are not in memory, and have indices of 64 bits.
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

/// What a component is called that is not finished: a triangle of it, which no other ever has.
using ComponentName = std::array<std::uint64_t, 3>;

/// As Polygon (rbpa/shape.h), to the last bit.
struct CornerPolygon {
  CornerRing shell = {};               ///< counter-clockwise
  std::vector<CornerRing> holes = {};  ///< clockwise; by first point, then by second
  double area = 0;                     ///< the real number rounded once
  double perimeter = 0;
  /// Input points in it, repetitions counted; one in which several polygons touch counts in the first of them.
  std::uint64_t points = 0;
  /// Of holes that were taken before it was finished (take_holes()): how many, and the names by which they are its own,
  /// ascending. Area and perimeter have them in.
  std::uint64_t taken_holes = 0;
  std::vector<ComponentName> names = {};
  friend bool operator==(const CornerPolygon&, const CornerPolygon&) = default;
};

/// The order of polygons: by the first point of the shell, then by the second.
RBPA_API bool comes_before(const CornerPolygon& a, const CornerPolygon& b);

}  // namespace rbpa
