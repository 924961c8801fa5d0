// What: the points of a tile in a file of scratch: those that it owns, and those around it that matter for them.
// Law:  what is read is what was written, or Damaged.
// Cost: of a file some blocks are in memory at a time. The format is in docs/stream.md.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/interrupt.h"
#include "rbpa/base/point.h"
#include "rbpa/region.h"
#include "stream/pack_block.h"
#include "stream/scratch_file.h"

namespace rbpa::app {

/// A file of scratch is not what was written.
class Damaged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The summary of a file, which must be correct when the file is read.
struct TileSummary {
  std::uint64_t points = 0;  ///< all of the file
  std::uint64_t owned = 0;   ///< those in the box
  std::uint64_t bytes = 0;   ///< of the blocks
  std::uint64_t blocks = 0;
  std::uint32_t checksum = 0;  ///< CRC-32 of the checksums of all blocks
  friend bool operator==(const TileSummary&, const TileSummary&) = default;
};

/// Appends blocks to the file at `path`, which is open only while that is done.
class TileWriter {
 public:
  TileWriter(std::string path, const Region& box, double alpha);

  /// Keeps the point. Requires: the index is larger than all before.
  void add(const Point& p, std::uint64_t index, bool owned) {
    waiting_.points.push_back(p);
    waiting_.indices.push_back(index);
    summary_.owned += owned ? 1 : 0;
  }
  /// Goes on with the file as it was when that much was in it. Throws Damaged when there is less now; Failure.
  void resume(const TileSummary& summary);

  const TileSummary& summary() const { return summary_; }
  std::size_t waiting() const { return waiting_.size(); }
  /// Writes the points that wait. Throws Failure.
  void flush();
  /// The same, and the header: the file is whole. Throws Failure.
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
  /// Throws Damaged when the file is not there or is none of a tile; Failure.
  explicit TileReader(const std::string& path);
  /// The same when it is not of this box and alpha.
  TileReader(const std::string& path, const Region& box, double alpha);
  ~TileReader();
  TileReader(const TileReader&) = delete;
  TileReader& operator=(const TileReader&) = delete;

  const Region& box() const { return box_; }
  double alpha() const { return alpha_; }
  const TileSummary& summary() const { return summary_; }
  /// Appends a block; false at the end. Throws Damaged, Failure.
  bool next(IndexedPoints& points);

 private:
  [[noreturn]] void damaged() const;
  void read(char* to, std::size_t size);

  std::string path_;
  std::unique_ptr<ScratchFile> file_;
  Region box_ = {};
  double alpha_ = 0;
  TileSummary summary_ = {};
  std::uint64_t blocks_ = 0, points_ = 0;
  std::uint32_t checksum_ = 0;
  std::string buffer_ = {};
};

/// All points that are still to come. Throws Damaged, Failure, Cancelled.
IndexedPoints read_tile(TileReader& reader);
/// Calls visit(block) with them, some at a time.
template <typename Visit>
void for_each_block(TileReader& reader, Visit visit) {
  for (IndexedPoints block; reader.next(block); block.clear()) {
    stop_if_interrupted();
    visit(block);
  }
}

}  // namespace rbpa::app
