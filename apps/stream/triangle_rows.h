// What: stores triangles in files of scratch by their least index, and reads them sorted.
// Law:  all added triangles come out in lexicographic order, which is the canonical order of files.
// Cost: each triangle is written once. sorted() reads a file once to count, and once for each part of it that fits into
//       `memory`; a small, sparse file once in all. Memory: the buffers of all files while rows are added.
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

/// The state of the files, from which they are resumed.
struct RowsState {
  std::vector<std::uint64_t> rows = {};  ///< number of rows of each file
  std::vector<std::uint64_t> sums = {};  ///< checksum of each file: a sum over its rows
  std::uint64_t total() const;
};

class TriangleRows {
 public:
  /// Takes triangles of `points` points. A file has about `file_bytes` bytes at most, unless that takes more than 4096
  /// files, or buffers of more than a quarter of `file_bytes`: then files are larger.
  TriangleRows(const Scratch& scratch, std::uint64_t points, std::uint64_t file_bytes);

  /// Resumes the files from a state, and cuts off rows that were written after it. Throws BadInput if there are other
  /// files, or one is too short; sorted() finds other damage.
  void resume(const RowsState& state);
  /// Adds triangles. Requires: the smallest index of each is first, and all are below the number of points.
  void add(std::span<const TriangleRow> triangles);
  /// Writes everything that was added to the files, and returns their state.
  RowsState flush();

  /// Returns whether an index in a row has 4 bytes; otherwise it has 8.
  bool are_short() const { return short_; }
  /// Calls write(bytes) with all rows in order, some at a time, little-endian. Uses about `memory` bytes, and 4 for
  /// each least index of a file. Requires: flush() after the last add(). Throws BadInput if a file is damaged, perhaps
  /// after other rows were written.
  void sorted(std::uint64_t memory, const std::function<void(std::string_view bytes)>& write) const;

 private:
  struct Bucket {
    std::string waiting = {};
    std::uint64_t rows = 0, sum = 0;
  };

  std::size_t row_bytes() const { return short_ ? 12 : 24; }
  void write(std::size_t bucket);

  const Scratch& scratch_;
  bool short_;                // indices have 4 bytes, not 8
  std::uint64_t width_;       // number of least indices in a bucket
  std::size_t most_waiting_;  // bytes of a bucket, a whole number of rows
  std::vector<Bucket> buckets_;
};

}  // namespace rbpa::app
