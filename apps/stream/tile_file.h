// What: the file of a tile in the scratch: the points that the tile owns, and those around it that matter for them.
// Law:  reading returns what was written, or throws Damaged.
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

/// Thrown if a file of scratch is not what was written.
class Damaged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The summary of a file, which must be correct when the file is read.
struct TileSummary {
  std::uint64_t points = 0;  ///< all points of the file
  std::uint64_t owned = 0;   ///< points in the box
  std::uint64_t bytes = 0;   ///< size of the blocks
  std::uint64_t blocks = 0;
  std::uint32_t checksum = 0;  ///< CRC-32 of the checksums of all blocks
  friend bool operator==(const TileSummary&, const TileSummary&) = default;
};

/// Appends blocks to the file at `path`, which is open only during a write.
class TileWriter {
 public:
  TileWriter(std::string path, const Region& box, double alpha);

  /// Adds a point. Requires: the index is larger than all before.
  void add(const Point& p, std::uint64_t index, bool owned) {
    waiting_.points.push_back(p);
    waiting_.indices.push_back(index);
    summary_.owned += owned ? 1 : 0;
  }
  /// Resumes the file from the state of `summary`. Throws Damaged if there is less in it, Failure.
  void resume(const TileSummary& summary);

  const TileSummary& summary() const { return summary_; }
  std::size_t waiting() const { return waiting_.size(); }
  /// Writes the points that wait. Throws Failure.
  void flush();
  /// Writes the points that wait and the header, which completes the file. Throws Failure.
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

/// Reads a file block by block.
class TileReader {
 public:
  /// Opens a file. Throws Damaged if it is missing, is not the file of a tile, or has another box or alpha; Failure.
  TileReader(const std::string& path, const Region& box, double alpha);
  ~TileReader();
  TileReader(const TileReader&) = delete;
  TileReader& operator=(const TileReader&) = delete;

  const TileSummary& summary() const { return summary_; }
  /// Appends a block to `points`. Returns false at the end. Throws Damaged, Failure.
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

/// Returns all points that are not read yet. Throws Damaged, Failure, Cancelled.
IndexedPoints read_tile(TileReader& reader);
/// Calls visit(block) with all points that are not read yet, block by block. Throws as read_tile().
template <typename Visit>
void for_each_block(TileReader& reader, Visit visit) {
  for (IndexedPoints block; reader.next(block); block.clear()) {
    stop_if_interrupted();
    visit(block);
  }
}

}  // namespace rbpa::app
