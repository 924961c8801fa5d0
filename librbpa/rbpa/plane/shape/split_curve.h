// What: splits a boundary curve that passes points several times into rings that pass each point once.
// Law:  every edge of the curve is on exactly one ring, in its direction. For curves of solid complexes the rings are
//       the boundaries of the connected pieces of the outside, whatever the first point of the curve is
//       (docs/explanation/plane.md, section 23).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

class CurveSplitter {
 public:
  /// Prepares for curves whose point indices are below `points`.
  explicit CurveSplitter(std::size_t points) : place_(points, nowhere) {}

  /// Appends the rings of a closed curve to `rings`; a ring may begin at any of its points. Cost: linear in the curve.
  void split(std::span<const std::uint32_t> curve, std::vector<Ring>& rings);

 private:
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

  /// Removes the points from position `first` on from walked_, and returns them as a ring.
  Ring take(std::size_t first);

  std::vector<std::uint32_t> walked_;  // the points passed since the last ring was cut off; no point twice
  std::vector<std::uint32_t> place_;   // for each point, its position in walked_
};

}  // namespace rbpa
