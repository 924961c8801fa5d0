// What: decompresses the point records of a LAZ file, which are then read as those of LAS.
// Law:  the records, and messages about bytes that cannot be decoded, do not depend on the number of threads.
// Cost: chunks are decoded by all threads, also by that of the caller while it waits; in memory are the compressed and
//       decompressed bytes of two chunks for each thread, at most some tens of megabytes. A chunk whose size is not
//       known, or that is larger than 8 MiB, is decoded by one thread at a time, in pieces.
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
  std::uint64_t first() const { return piece_.first + skipped_ / format_.length; }
  /// Skips `size` bytes of those that ahead() returned.
  void skip(std::size_t size) { skipped_ += size; }

  /// Returns why records are left out; empty if none are.
  const std::string& fault() const { return piece_.fault; }
  std::uint64_t bytes_read() const { return piece_.bytes_read; }

 private:
  /// Consecutive points of a chunk: first their compressed bytes, then their records up to the fault, if there is one.
  struct Piece {
    std::vector<char> compressed = {}, records = {};
    std::uint64_t place = 0, first = 0;  // offset of the compressed bytes in the file; number of the first point
    std::size_t points = 0;
    std::string fault = {};
    std::uint64_t bytes_read = 0;
  };

  /// Takes the next chunk for decode(), or decodes the next piece of one. Returns false at the end.
  bool make(Piece& piece);
  /// Decodes a chunk that make() has taken.
  void decode(Piece& piece) const;
  /// Begins the next chunk, with its bytes in window_ if their number is known.
  void begin_chunk();
  /// Decodes points to piece.records. Throws BadStream as ChunkDecoder; then the records before are there.
  void decode(ChunkDecoder& decoder, std::size_t points, Piece& piece) const;
  /// Ends a piece at a fault in `bytes`, which are from byte `place` of the file on. Throws BadInput that names the
  /// byte, unless LazChoice::skip_invalid.
  void end_at(const BadStream& fault, std::string_view bytes, std::uint64_t place, Piece& piece) const;
  /// Marks the chunks of the choice in is_wanted_. Throws BadInput unless each of them is in the table.
  void choose_chunks();
  /// Sets window_ to the next `size` bytes of the file, and returns them. Throws BadStream if there are fewer.
  std::string_view require_ahead(std::uint64_t size);
  /// Returns whether the size of chunks in bytes is known only when they are decoded.
  bool is_windowed() const { return !table_ && !format_.is_layered; }
  /// Returns the size of a chunk, compressed and decompressed.
  std::size_t bytes_of(const LazChunk& chunk) const { return chunk.size + chunk.points * format_.length; }

  Content content_;
  LazFormat format_;
  LazChoice choice_;
  std::optional<std::vector<LazChunk>> table_ = std::nullopt;
  std::vector<bool> is_wanted_ = {};                    // for each chunk of table_, if some are chosen
  std::size_t next_chunk_ = 0, left_;                   // left_: points in chunks that are not begun, and are wanted
  std::uint64_t first_ = 0;                             // number of the first point of the next chunk
  std::string_view window_ = {};                        // the bytes that are being decoded
  std::uint64_t place_;                                 // of window_ in the file
  LazChunk chunk_ = {};                                 // the current chunk; its size is 0 if it is not known
  std::size_t chunk_left_ = 0;                          // points of chunk_ that are not taken or decoded
  std::optional<ChunkDecoder> decoder_ = std::nullopt;  // of a chunk that is decoded in pieces
  bool ended_ = false;

  Piece piece_ = {};  // has the records that ahead() returns
  std::size_t skipped_ = 0;
  std::optional<ReadAhead<Piece>> pieces_ = std::nullopt;  // the last member, as its threads use the others
};

}  // namespace rbpa::app
