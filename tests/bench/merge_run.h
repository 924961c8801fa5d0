// What: tiles of a square of ground, computed and merged two by two as the plane was halved, each result by way of its
//       bytes: what a cluster sends from machine to machine.
// Law:  a function of the size and the seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rbpa_bench {

/// A rectangle of tiles.
struct TileBlock {
  std::int64_t column, row, last_column, last_row;  ///< the last not included

  double tiles() const { return static_cast<double>(last_column - column) * static_cast<double>(last_row - row); }
};

/// So many tiles by so many, with so many points along a side of each.
struct MergePlan {
  std::int64_t across, side;
  double alpha;
  std::uint64_t seed;

  TileBlock all() const { return {0, 0, across, across}; }
  /// Lengths of the border of a block, in spacings: inside the ground, and at its end.
  double inner_border(const TileBlock& block) const;
  double outer_border(const TileBlock& block) const;
};

/// A result of the tree: of one tile, or of two results.
struct MergedPart {
  TileBlock block;
  std::size_t depth;  ///< in the tree; of all tiles 0
  double bytes;       ///< of the Partial, without the polygons and holes removed
  double points;      ///< in the block
};

struct MergeRun {
  std::vector<MergedPart> parts = {};
  double points = 0, triangles = 0;
  double taken_bytes = 0;    ///< 16 a corner of polygons and holes that went to storage
  double tile_seconds = 0;   ///< of the processor: partial(), without making the points
  double merge_seconds = 0;  ///< merging, and to bytes and back
};

/// The two halves of a block of more than one tile.
struct Halves {
  TileBlock first, second;
};
Halves halves_of(const TileBlock& block);

MergeRun run_merges(const MergePlan& plan);

}  // namespace rbpa_bench
