// What: some points and their indices as few bytes.
// Law:  unpacking gives the same bits, those of -0 included.
// Cost: one pass; coordinates with few decimals take as many bits as their distance from the least of the block needs,
//       others at most 64. The format is in docs/stream.md.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa::app {

/// Points and where they are in the input.
struct IndexedPoints {
  std::vector<Point> points = {};
  std::vector<std::uint64_t> indices = {};  ///< ascending, one for each point

  std::size_t size() const { return points.size(); }
  void clear() {
    points.clear();
    indices.clear();
  }
};

/// The most points that a block may have.
constexpr std::size_t most_in_packed_block = 4096;

/// How the last blocks of a tile had their decimals: where the search for those of the next begins.
struct PackingHint {
  unsigned places[2] = {0, 0};
};

/// Appends the block. Requires 1 to most_in_packed_block points, finite, with ascending indices.
void pack_block(std::span<const Point> points, std::span<const std::uint64_t> indices, PackingHint& hint,
                std::string& bytes);

/// Appends the points of a block. Returns false when the bytes are none.
bool unpack_block(std::string_view bytes, IndexedPoints& points);

}  // namespace rbpa::app
