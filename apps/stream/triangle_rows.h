// What: stores triangles in files of scratch by their least index, and reads all of them sorted.
// Law:  sorted() writes all added triangles in lexicographic order, which is the canonical order of files.
// Cost: each triangle is written once. sorted() reads each file once to count, and once more for each part that fits
//       into `memory`; a small, sparse file only once. Memory: the buffers of all files while triangles are added.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "stream/scratch.h"

namespace rbpa::app {

using TriangleRow = std::array<std::uint64_t, 3>;

/// The state of the files, from which writing can be resumed: the numbers and checksums of their rows.
struct RowsState {
  std::vector<std::uint64_t> rows = {};  ///< number of rows of each file
  std::vector<std::uint64_t> sums = {};  ///< checksum of each file: the sum of the hashes of its rows
  std::uint64_t total() const;
};

class TriangleRows {
 public:
  /// Prepares files for triangles of `points` points. A file has at most about `file_bytes` bytes. Files are larger if
  /// there would otherwise be more than 4096 of them, or their buffers would exceed a quarter of `file_bytes`. Keeps a
  /// reference to `scratch`.
  TriangleRows(const Scratch& scratch, std::uint64_t points, std::uint64_t file_bytes);

  /// Continues from a state that flush() returned: cuts off rows that were written later. Throws BadInput if the state
  /// has another number of files, or a file is too short; Failure. Only sorted() finds other damage.
  void resume(const RowsState& state);
  /// Adds triangles. Requires: the smallest index of each triangle comes first; all indices are below `points` of the
  /// constructor. Throws Failure, Cancelled.
  void add(std::span<const TriangleRow> triangles);
  /// Writes all added triangles to the files, and returns the state of the files. Throws Failure, Cancelled.
  RowsState flush();

  /// Returns whether an index in a row has 4 bytes; otherwise an index has 8 bytes.
  bool are_short() const { return short_; }
  /// Calls write(bytes) for all rows in order, several rows in each call, little-endian. Uses about `memory` bytes, and
  /// 4 bytes for each index that may be the least of a file. Requires: flush() after the last add(). Throws BadInput if
  /// a file is damaged, perhaps after other rows were written; Failure, Cancelled, and what write() throws.
  void sorted(std::uint64_t memory, const std::function<void(std::string_view bytes)>& write) const;

 private:
  struct Bucket {
    std::string waiting = {};
    std::uint64_t rows = 0, sum = 0;
  };

  std::size_t row_bytes() const { return short_ ? 12 : 24; }
  void write(std::size_t bucket);

  const Scratch& scratch_;
  bool short_;                // true if an index has 4 bytes, false if 8
  std::uint64_t width_;       // number of indices that may be the least of a row in one bucket
  std::size_t most_waiting_;  // the most waiting bytes of a bucket, a whole number of rows
  std::vector<Bucket> buckets_;
};

}  // namespace rbpa::app
