#include "io/mesh/equal_positions.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "io/interrupt.h"

namespace rbpa::app {
namespace {

std::size_t hash_of(const Position& p) {
  std::uint64_t hash = 0;
  for (const double coordinate : p) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9E3779B97F4A7C15U;  // −0 becomes +0
    hash ^= hash >> 32U;
  }
  return hash;
}

}  // namespace

EqualPositions::EqualPositions(std::size_t places)
    : slots_(std::bit_ceil(2 * std::max<std::size_t>(places, 8)), none) {}

std::uint32_t EqualPositions::first_at(std::span<const Position> positions, std::uint32_t i) {
  if (2 * taken_ >= slots_.size()) grow(positions);
  std::uint32_t& slot = slot_of(positions, i);
  if (slot != none) return slot;
  ++taken_;
  return slot = i;
}

/// Returns the slot of the first queried point at the position of point `i`; a free slot if there is none.
std::uint32_t& EqualPositions::slot_of(std::span<const Position> positions, std::uint32_t i) {
  std::size_t at = hash_of(positions[i]);
  while (true) {
    std::uint32_t& slot = slots_[at++ & (slots_.size() - 1)];
    if (slot == none || positions[slot] == positions[i]) return slot;
  }
}

void EqualPositions::grow(std::span<const Position> positions) {
  const auto before = std::exchange(slots_, meshops::FreshVector<std::uint32_t>(2 * slots_.size(), none));
  std::size_t moved = 0;
  for (const std::uint32_t first : before) {
    if (++moved % 65536 == 0) stop_if_interrupted();
    if (first != none) slot_of(positions, first) = first;
  }
}

}  // namespace rbpa::app
