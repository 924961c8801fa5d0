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
  /// Makes room for `places` different positions. The table grows if there are more.
  explicit EqualPositions(std::size_t places);

  /// Returns the point at the position of point `i` that was queried first; `i` itself if there is no other. Requires:
  /// `positions` has the position of each queried point, the same in every call. Cost: one memory access on average.
  /// Throws Cancelled.
  std::uint32_t first_at(std::span<const Position> positions, std::uint32_t i);

 private:
  static constexpr std::uint32_t none = ~0U;

  std::uint32_t& slot_of(std::span<const Position> positions, std::uint32_t i);
  void grow(std::span<const Position> positions);

  meshops::FreshVector<std::uint32_t> slots_;  // their number is a power of two; at most half of them are taken
  std::size_t taken_ = 0;
};

}  // namespace rbpa::app
