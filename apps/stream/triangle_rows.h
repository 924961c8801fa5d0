// What: triangles in files of scratch by their least index, and from there in order.
// Law:  what comes out are all triangles that were added, in lexicographic order: the canonical order of files.
// Cost: each triangle is written once and read twice; memory as the buffers of all files, at the end as a file.
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

/// Whether indices of so many points have 4 bytes, not 8.
bool have_short_indices(std::uint64_t points);

/// How far the files have come.
struct RowsState {
  std::vector<std::uint64_t> rows = {};  ///< of each file
  std::vector<std::uint64_t> sums = {};  ///< of a number for each row, of each file
  std::uint64_t total() const;
};

class TriangleRows {
 public:
  /// Of so many points, so that a file is about so many bytes at most, as long as what waits to be written to all files
  /// takes a quarter of that at most.
  TriangleRows(const Scratch& scratch, std::uint64_t points, std::uint64_t file_bytes);

  /// Goes on where the files had come to. Throws BadInput when they are not as they were.
  void resume(const RowsState& state);
  /// Requires: the smallest index first, all of them below the number of points.
  void add(std::span<const TriangleRow> triangles);
  /// All that was added is in the files.
  RowsState flush();

  bool are_short() const { return short_; }
  /// Calls write(bytes) with all rows in order, as they lie in memory of a little-endian machine. With about so many
  /// bytes of memory; throws BadInput when a file is not as it was written.
  void sorted(std::uint64_t memory, const std::function<void(std::string_view bytes)>& write) const;

 private:
  struct Bucket {
    std::string waiting = {};
    std::uint64_t rows = 0, sum = 0;
  };

  std::size_t row_bytes() const { return short_ ? 12 : 24; }
  void write(std::size_t bucket);

  const Scratch& scratch_;
  bool short_;
  std::uint64_t width_;       // indices of a bucket
  std::size_t most_waiting_;  // bytes of a bucket, a whole number of rows
  std::vector<Bucket> buckets_;
};

}  // namespace rbpa::app
