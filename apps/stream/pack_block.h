// What: compresses and decompresses points and their indices, block by block.
// Law:  decompressing gives the bits of the compressed coordinates and indices, also for -0.
// Cost: one pass. A column of coordinates with few decimal places takes for each point the bits of its largest distance
//       from the least coordinate; any other column at most 64 bits. docs/reference/file_formats.md has the format.
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
  std::vector<std::uint64_t> indices = {};  ///< input index of each point, ascending

  std::size_t size() const { return points.size(); }
  void clear() {
    points.clear();
    indices.clear();
  }
};

/// The most points that a block may have.
constexpr std::size_t most_in_packed_block = 4096;

/// The numbers of decimal places of x and y in the last block of a tile; the search for the next block begins there.
struct PackingHint {
  unsigned places[2] = {0, 0};
};

/// Appends a compressed block to `bytes`, and updates `hint`. Requires: 1 to most_in_packed_block finite points with
/// ascending indices.
void pack_block(std::span<const Point> points, std::span<const std::uint64_t> indices, PackingHint& hint,
                std::string& bytes);

/// Appends the points of the block `bytes` to `points`. Returns false, with `points` unspecified, if it is no block.
bool unpack_block(std::string_view bytes, IndexedPoints& points);

}  // namespace rbpa::app
