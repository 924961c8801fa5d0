// What: a polygon with holes whose corners are indices of points.
#pragma once

#include <cstdint>
#include <vector>

namespace rbpa {

/// A closed polyline that passes no point twice.
struct Ring {
  std::vector<std::uint32_t> points;  ///< indices of points, the lexicographically least point first and not repeated
  friend bool operator==(const Ring&, const Ring&) = default;
};

/// A polygon with holes. The interior is connected; rings touch each other at single points, if at all.
struct Polygon {
  Ring shell = {};  ///< counter-clockwise
  /// The holes: clockwise, inside the shell; sorted by first point, then by second, both lexicographically.
  std::vector<Ring> holes = {};
  double area = 0;  ///< area of the shell minus that of the holes: the real number rounded once
  /// Length of all rings, with a relative error of at most 4 · 2⁻⁵³. Area and perimeter are infinite beyond the range
  /// of double.
  double perimeter = 0;
  friend bool operator==(const Polygon&, const Polygon&) = default;
};

}  // namespace rbpa
