// What: computes tiles of a square of ground and merges them two by two, in the order in which the plane was halved,
//       each result by way of its bytes: the data that a cluster sends from machine to machine.
// Law:  the result is a function of the size and the seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rbpa_bench {

/// Rectangle of tiles.
struct TileBlock {
  std::int64_t column, row, last_column, last_row;  ///< the last column and row are not included

  double tiles() const { return static_cast<double>(last_column - column) * static_cast<double>(last_row - row); }
};

/// Plan: the number of tiles along each side, and of points along a side of a tile.
struct MergePlan {
  std::int64_t across, side;
  double alpha;
  std::uint64_t seed;

  TileBlock all() const { return {0, 0, across, across}; }
  /// Return the length of the border of a block, in spacings: inside the ground, and at its end.
  double inner_border(const TileBlock& block) const;
  double outer_border(const TileBlock& block) const;
};

/// Result in the tree: one tile, or two merged results.
struct MergedPart {
  TileBlock block;
  std::size_t depth;  ///< depth in the tree; 0 for all tiles together
  double bytes;       ///< size of the Partial, without removed polygons and holes
  double points;      ///< number of points in the block
};

struct MergeRun {
  std::vector<MergedPart> parts = {};
  double points = 0, triangles = 0;
  double taken_bytes = 0;    ///< 16 per corner of polygons and holes that went to storage
  double tile_seconds = 0;   ///< processor time of partial(), without making the points
  double merge_seconds = 0;  ///< time of merging, and of converting to bytes and back
};

/// The two halves of a block of more than one tile.
struct Halves {
  TileBlock first, second;
};
Halves halves_of(const TileBlock& block);

MergeRun run_merges(const MergePlan& plan);

}  // namespace rbpa_bench
