// What:   computes positions of cells on the Hilbert curve through a cube.
// Law:    consecutive cells of the curve share a face.
// How:    a state consists of the corner at which the curve enters the cube and the axis along which the curve leaves.
//         A table gives the state of each octant:
//
//             state (entry, axis) × octant → position among the eight, state within the octant
//
// Cost:   a look-up for each level.
// Source: Hamilton, Compact Hilbert indices (2006).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace rbpa::space {

namespace detail {

struct HilbertStep {
  std::uint8_t position, next_state;
};

inline constexpr std::size_t hilbert_states = 24;  // state = 8 · axis + entry

/// Returns the steps as a table: the step of a state and an octant is element [state][octant].
constexpr std::array<std::array<HilbertStep, 8>, hilbert_states> hilbert_steps() {
  const auto turned = [](unsigned bits, unsigned by) { return (bits << by | bits >> (3 - by)) & 7U; };
  const auto gray = [](unsigned i) { return i ^ (i >> 1U); };
  std::array<std::array<HilbertStep, 8>, hilbert_states> steps{};
  for (unsigned axis = 0; axis < 3; ++axis)
    for (unsigned entry = 0; entry < 8; ++entry)
      for (unsigned i = 0; i < 8; ++i) {
        const unsigned turn = (axis + 1) % 3, octant = turned(gray(i), turn) ^ entry;
        const unsigned enters = i == 0 ? 0 : gray((i - 1) & ~1U);
        const unsigned along = i == 0 ? 0 : static_cast<unsigned>(std::countr_one(i % 2 == 0 ? i - 1 : i)) % 3;
        const unsigned next_entry = entry ^ turned(enters, turn), next_axis = (axis + along + 1) % 3;
        steps[8 * axis + entry][octant] = {static_cast<std::uint8_t>(i),
                                           static_cast<std::uint8_t>(8 * next_axis + next_entry)};
      }
  return steps;
}

}  // namespace detail

/// Returns the position of cell (x, y, z) on the curve through a cube with 2^levels cells along each axis. Requires:
/// coordinates below 2^levels, levels ≤ 21.
inline std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t z, int levels) {
  static constexpr auto steps = detail::hilbert_steps();
  std::uint64_t index = 0;
  std::size_t state = 0;
  for (int level = levels - 1; level >= 0; --level) {
    const std::uint32_t octant = (x >> level & 1U) | (y >> level & 1U) << 1U | (z >> level & 1U) << 2U;
    const detail::HilbertStep step = steps[state][octant];
    index = index << 3U | step.position;
    state = step.next_state;
  }
  return index;
}

}  // namespace rbpa::space
