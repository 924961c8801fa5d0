// What: writes and reads the file of a tile in scratch: the points that the tile owns, and the points around the tile
//       that its computation needs.
// Law:  reading returns the written points, or throws Damaged.
// Cost: memory of a few blocks. docs/reference/file_formats.md has the format.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/interrupt.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/region.h"
#include "stream/pack_block.h"
#include "stream/scratch_file.h"

namespace rbpa::app {

/// The exception if the file of a tile is missing, or differs from what was written.
class Damaged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The summary of the file of a tile. A file that is read must match its summary.
struct TileSummary {
  std::uint64_t points = 0;  ///< number of all points of the file
  std::uint64_t owned = 0;   ///< number of points in the box of the tile
  std::uint64_t bytes = 0;   ///< size of all blocks, in bytes
  std::uint64_t blocks = 0;
  std::uint32_t checksum = 0;  ///< CRC-32 of the sizes and checksums of all blocks
  friend bool operator==(const TileSummary&, const TileSummary&) = default;
};

/// Appends blocks to the file at `path`. The file is open only while bytes are written.
class TileWriter {
 public:
  TileWriter(std::string path, const Region& box, double alpha);

  /// Adds a point to the points that wait in memory. `owned` tells whether the point is in the box of the tile.
  /// Requires: `index` is larger than all indices added earlier.
  void add(const Point& p, std::uint64_t index, bool owned) {
    waiting_.points.push_back(p);
    waiting_.indices.push_back(index);
    summary_.owned += owned ? 1 : 0;
  }
  /// Continues the file from the state `summary`: cuts off bytes that were written later. Throws Damaged if the file is
  /// missing or shorter than that; Failure.
  void resume(const TileSummary& summary);

  const TileSummary& summary() const { return summary_; }
  std::size_t waiting() const { return waiting_.size(); }
  /// Writes the waiting points. Throws Failure, Cancelled.
  void flush();
  /// Writes the waiting points and the header, which completes the file. Returns the summary of the file. Throws
  /// Failure, Cancelled.
  TileSummary finish();

 private:
  std::string path_;
  Region box_;
  double alpha_;
  TileSummary summary_ = {};
  IndexedPoints waiting_ = {};
  PackingHint hint_ = {};
  bool begun_ = false;
};

/// Reads the file of a tile block by block.
class TileReader {
 public:
  /// Opens the file at `path`. Throws Damaged if the file is missing, is not the file of a tile, or has another box or
  /// alpha; Failure.
  TileReader(const std::string& path, const Region& box, double alpha);
  ~TileReader();
  TileReader(const TileReader&) = delete;
  TileReader& operator=(const TileReader&) = delete;

  const TileSummary& summary() const { return summary_; }
  /// Appends the points of the next block to `points`. Returns false at the end. Throws Damaged, Failure, Cancelled.
  bool next(IndexedPoints& points);

 private:
  [[noreturn]] void damaged() const;
  void read(char* to, std::size_t size);

  std::string path_;
  std::unique_ptr<ScratchFile> file_;
  TileSummary summary_ = {};
  std::uint64_t blocks_ = 0, points_ = 0;
  std::uint32_t checksum_ = 0;
  std::string buffer_ = {};
};

/// Returns all points that `reader` has not read yet. Throws Damaged, Failure, Cancelled.
IndexedPoints read_tile(TileReader& reader);
/// Calls visit(block) for each block that `reader` has not read. Throws as read_tile() does, and what visit() throws.
template <typename Visit>
void for_each_block(TileReader& reader, Visit visit) {
  for (IndexedPoints block; reader.next(block); block.clear()) {
    stop_if_interrupted();
    visit(block);
  }
}

}  // namespace rbpa::app
