// What: stores triangles in files of scratch by their least index, and reads them sorted.
// Law:  sorted() writes all added triangles in lexicographic order, which is the canonical order of files.
// Cost: each triangle is written once. sorted() reads each file once to count, and once for each part that fits into
//       `memory`; a small, sparse file only once. Memory: the buffers of all files while rows are added.
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

/// The state of the files when writing stops, from which it can be resumed: the numbers and checksums of their rows.
struct RowsState {
  std::vector<std::uint64_t> rows = {};  ///< number of rows of each file
  std::vector<std::uint64_t> sums = {};  ///< checksum of each file: the sum of the hashes of its rows
  std::uint64_t total() const;
};

class TriangleRows {
 public:
  /// For triangles of `points` points. A file has at most about `file_bytes` bytes, unless that would take more than
  /// 4096 files, or buffers of more than a quarter of `file_bytes`; then files are larger. Keeps a reference to
  /// `scratch`.
  TriangleRows(const Scratch& scratch, std::uint64_t points, std::uint64_t file_bytes);

  /// Continues from a state that flush() returned: cuts off rows written after that state. Throws BadInput if the
  /// number of files is not that of the state, or a file is too short; Failure. Only sorted() finds other damage.
  void resume(const RowsState& state);
  /// Adds triangles. Requires: the smallest index of each triangle is first, and all indices are below `points` of the
  /// constructor. Throws Failure, Cancelled.
  void add(std::span<const TriangleRow> triangles);
  /// Writes all added triangles to the files, and returns the state of the files. Throws Failure, Cancelled.
  RowsState flush();

  /// Returns whether an index in a row has 4 bytes; otherwise it has 8.
  bool are_short() const { return short_; }
  /// Calls write(bytes) with all rows in order, some at a time, little-endian. Uses about `memory` bytes, and 4 bytes
  /// for each index that may be least in a file. Requires: flush() after the last add(). Throws BadInput if a file is
  /// damaged, perhaps after other rows were written; Failure, Cancelled, and what write() throws.
  void sorted(std::uint64_t memory, const std::function<void(std::string_view bytes)>& write) const;

 private:
  struct Bucket {
    std::string waiting = {};
    std::uint64_t rows = 0, sum = 0;
  };

  std::size_t row_bytes() const { return short_ ? 12 : 24; }
  void write(std::size_t bucket);

  const Scratch& scratch_;
  bool short_;                // true: indices have 4 bytes; false: 8
  std::uint64_t width_;       // number of indices that may be least in a bucket
  std::size_t most_waiting_;  // the most waiting bytes of a bucket, a whole number of rows
  std::vector<Bucket> buckets_;
};

}  // namespace rbpa::app
