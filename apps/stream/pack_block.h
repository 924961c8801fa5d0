// What: compresses and decompresses points and their indices.
// Law:  decompressing gives the same bits, also for -0.
// Cost: one pass. A coordinate with few decimals takes as many bits as its distance from the least coordinate of the
//       block needs, any other at most 64. docs/reference/file_formats.md has the format.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa::app {

/// Points and their indices in the input.
struct IndexedPoints {
  std::vector<Point> points = {};
  std::vector<std::uint64_t> indices = {};  ///< index of each point, ascending

  std::size_t size() const { return points.size(); }
  void clear() {
    points.clear();
    indices.clear();
  }
};

/// The most points that a block may have.
constexpr std::size_t most_in_packed_block = 4096;

/// The numbers of decimal places of the last block of a tile, with which the search for those of the next block begins.
struct PackingHint {
  unsigned places[2] = {0, 0};
};

/// Appends a compressed block to `bytes`, and updates `hint`. Requires: 1 to most_in_packed_block points, finite, with
/// ascending indices.
void pack_block(std::span<const Point> points, std::span<const std::uint64_t> indices, PackingHint& hint,
                std::string& bytes);

/// Appends the points of the block `bytes` to `points`. Returns false if the bytes are not a block.
bool unpack_block(std::string_view bytes, IndexedPoints& points);

}  // namespace rbpa::app
