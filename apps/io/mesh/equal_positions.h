// What: which points in space have the same place.
// Law:  places are the same when their three coordinates are equal numbers (−0 = +0), and not when they are only near.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "meshops/core/fresh_vector.h"

namespace rbpa::app {

using Position = std::array<double, 3>;

/// A hash table of the first point at each place.
class EqualPositions {
 public:
  /// With room for so many places; more make it grow.
  explicit EqualPositions(std::size_t places);

  /// The first of all points queried so far that is where point `i` is; `i` itself when it is the first. `positions`
  /// has all of those. Cost: a look into memory. Throws Cancelled.
  std::uint32_t first_at(std::span<const Position> positions, std::uint32_t i);

 private:
  static constexpr std::uint32_t none = ~0U;

  std::uint32_t& slot_of(std::span<const Position> positions, std::uint32_t i);
  void grow(std::span<const Position> positions);

  meshops::FreshVector<std::uint32_t> slots_;  // a power of two of them, at most half of them taken
  std::size_t taken_ = 0;
};

}  // namespace rbpa::app
