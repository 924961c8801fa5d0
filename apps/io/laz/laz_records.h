// What: decompresses the point records of a LAZ file, which are then read as those of LAS.
// Law:  the records do not depend on the number of threads.
// Cost: chunks are decoded by all threads while the caller reads records of the chunks before; in memory are the
//       compressed and decompressed bytes of as many chunks as there are threads, twice, at most some tens of
//       megabytes. Of a file without chunks or without their table only some thousand points at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/content.h"
#include "io/laz/chunk_decoder.h"
#include "rbpa/base/read_ahead.h"

namespace rbpa::app {

/// A chunk that the hierarchy of a COPC file names.
struct LazNode {
  std::uint64_t begin, size;  ///< its place in the file, in bytes
  std::size_t points;
  std::uint64_t entry;  ///< the byte of its entry in the hierarchy
};

struct LazChoice {
  std::vector<bool> wanted;   ///< the bytes of a record to decode, as for ChunkDecoder
  bool skip_invalid = false;  ///< the records end without an exception where they cannot be decoded
  unsigned threads = 0;       ///< the most threads that decode; 0: one for each processor
  /// The chunks to decode, ordered by their places; absent: all.
  std::optional<std::vector<LazNode>> nodes = std::nullopt;
};

class LazRecords {
 public:
  /// Decompresses `points` records from byte `begin` of `content` on. Throws BadInput.
  LazRecords(const Content& content, std::size_t begin, LazFormat format, std::size_t points, LazChoice choice);

  /// Returns the next records, at least one unless there are no more. The view is valid until the next call of ahead().
  /// Throws BadInput that names the byte, unless LazChoice::skip_invalid; Failure, Cancelled.
  std::string_view ahead();
  /// Returns the number, among the points of the file, of the first record that is not skipped.
  std::uint64_t first() const { return batch_.pieces[piece_].first + skipped_ / format_.length; }
  /// Skips `size` bytes of those that ahead() returned.
  void skip(std::size_t size) { skipped_ += size; }

  /// Returns why records are left out; empty if none are.
  const std::string& fault() const { return batch_.fault; }
  std::uint64_t bytes_read() const { return batch_.bytes_read; }

 private:
  /// Consecutive records, decoded by one thread up to the fault, if there is one.
  struct Piece {
    std::vector<char> records = {};
    std::uint64_t first = 0;  // number of its first record
    std::optional<BadStream> fault = std::nullopt;
  };
  struct Batch {
    std::vector<Piece> pieces = {};
    std::string fault = {};
    std::uint64_t bytes_read = 0;
  };
  /// A chunk that is being decoded.
  struct Slot {
    std::unique_ptr<ChunkDecoder> decoder;
    std::string_view bytes = {};
    std::vector<char> copy = {};         // has `bytes`, unless they are in window_
    std::uint64_t place = 0, first = 0;  // offset of the chunk in the file, in bytes; number of its first point
    std::size_t points = 0, left = 0;
  };

  /// Decodes the next chunks, or a part of one. Returns false at the end.
  bool make(Batch& batch);
  /// Fills slots_: with the next chunk, or with one chunk for each thread.
  void begin_chunks();
  /// Marks the chunks of the choice in is_wanted_. Throws BadInput unless each of them is in the table.
  void choose_chunks();
  /// Returns the place in the file of a byte that a decoder names.
  std::uint64_t place_of(const char* at) const;
  /// Returns the next `size` bytes of the file. Throws BadStream if there are fewer.
  std::string_view require_ahead(std::uint64_t size);
  /// Begins a chunk in the next slot.
  void begin(std::size_t points, std::string_view bytes);
  /// Returns the greatest number of records in a piece.
  std::size_t most_at_once() const;
  Piece decode(Slot& slot) const;
  /// Returns whether the size of a chunk in bytes is known only when the chunk is decoded.
  bool is_windowed() const { return !table_ && !format_.is_layered; }

  Content content_;
  LazFormat format_;
  LazChoice choice_;
  std::optional<std::vector<LazChunk>> table_ = std::nullopt;
  std::vector<bool> is_wanted_ = {};   // for each chunk of table_, if some are chosen
  std::size_t next_chunk_ = 0, left_;  // left_: points in chunks that are not begun, and are wanted
  std::uint64_t first_ = 0;            // number of the first point of the next chunk
  std::string_view window_ = {};       // the bytes that are being decoded; those of all slots
  std::uint64_t place_;                // of window_ in the file
  std::size_t threads_;
  std::vector<Slot> slots_ = {};
  std::size_t in_use_ = 0;  // slots
  bool ended_ = false;

  Batch batch_ = {};  // has the records that ahead() returns
  std::size_t piece_ = 0, skipped_ = 0;
  std::unique_ptr<ReadAhead<Batch>> batches_ = nullptr;  // the last member, as its thread uses the others
};

}  // namespace rbpa::app
