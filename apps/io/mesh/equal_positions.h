// What: finds points in space at equal positions.
// Law:  positions are equal if their three coordinates are equal numbers (−0 = +0); near positions differ.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

using Position = std::array<double, 3>;

inline Position position_of(const Point3& p) { return {p.x, p.y, p.z}; }

/// A hash table of the first point at each position.
class EqualPositions {
 public:
  /// Makes room for `places` positions; the table grows if there are more.
  explicit EqualPositions(std::size_t places);

  /// Returns the first of the points queried so far at the position of point `i`; `i` itself if it is the first.
  /// `positions` has the positions of all these points. Cost: one memory access. Throws Cancelled.
  std::uint32_t first_at(std::span<const Position> positions, std::uint32_t i);

 private:
  static constexpr std::uint32_t none = ~0U;

  std::uint32_t& slot_of(std::span<const Position> positions, std::uint32_t i);
  void grow(std::span<const Position> positions);

  meshops::FreshVector<std::uint32_t> slots_;  // a power of two of them, at most half of them taken
  std::size_t taken_ = 0;
};

}  // namespace rbpa::app
