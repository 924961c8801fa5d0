#include "stream/triangle_rows.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

#include "io/failure.h"
#include "io/interrupt.h"
#include "stream/scratch_file.h"

namespace rbpa::app {
namespace {

constexpr std::uint64_t few_bytes = std::uint64_t{1} << 20U;
constexpr std::size_t buffer_bytes = 12 * 4096;  // a whole number of rows, of 12 bytes or of 24

/// Returns a hash of a row. The sum of the hashes of several rows does not depend on the order of the rows.
std::uint64_t number_of(const TriangleRow& row) {
  std::uint64_t h = row[0] * 0x9e3779b97f4a7c15U;
  h = (h ^ h >> 32U ^ row[1]) * 0xc2b2ae3d27d4eb4fU;
  h = (h ^ h >> 29U ^ row[2]) * 0x165667b19e3779f9U;
  return h ^ h >> 32U;
}

/// A file of rows of three integers.
template <typename Index>
class RowFile {
 public:
  using Row = std::array<Index, 3>;

  explicit RowFile(const std::string& path) : file_(path, ScratchFile::Mode::read), rows_(buffer_bytes / sizeof(Row)) {}

  template <typename Visit>
  void for_each(Visit visit) {
    for (std::uint64_t at = 0;; at += rows_.size() * sizeof(Row)) {
      const std::size_t bytes = file_.read_at(at, reinterpret_cast<char*>(rows_.data()), rows_.size() * sizeof(Row));
      for (std::size_t i = 0; i < bytes / sizeof(Row); ++i) visit(rows_[i]);
      if (bytes < rows_.size() * sizeof(Row)) return;
    }
  }

 private:
  ScratchFile file_;
  std::vector<Row> rows_;
};

/// Returns the rows of a small file, sorted. Adds the hashes of the rows to `sum`.
template <typename Index>
std::vector<std::array<Index, 3>> sorted_rows(const std::string& path, std::uint64_t& sum) {
  std::vector<std::array<Index, 3>> rows;
  RowFile<Index>(path).for_each([&](const std::array<Index, 3>& row) {
    rows.push_back(row);
    sum += number_of({row[0], row[1], row[2]});
  });
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// Sorts the rows of a file part by part. Requires: the smallest index of each row is in [`first`, `last`).
template <typename Index>
class BucketSort {
 public:
  using Row = std::array<Index, 3>;

  BucketSort(const std::string& path, std::uint64_t first, std::uint64_t last, std::uint64_t memory)
      : file_(path),
        first_(first),
        counts_(last - first + 1),
        most_(std::max<std::uint64_t>(memory / sizeof(Row), 4096)) {}

  /// Counts the rows by smallest index, adds their number to `rows`, and returns the sum of the hashes of the rows.
  std::uint64_t count(std::uint64_t& rows) {
    std::uint64_t sum = 0;
    file_.for_each([&](const Row& row) {
      const std::uint64_t at = row[0] - first_;
      if (at + 1 >= counts_.size()) return;
      ++counts_[at];
      ++rows;
      sum += number_of({row[0], row[1], row[2]});
    });
    return sum;
  }

  template <typename Write>
  void write(Write write) {
    const std::size_t end = counts_.size() - 1;
    for (std::size_t begin = 0; begin < end;) {
      std::size_t last = begin;
      std::uint64_t rows = counts_[last++];
      while (last < end && rows + counts_[last] <= most_) rows += counts_[last++];
      write_part(begin, last, rows, write);
      begin = last;
    }
  }

 private:
  template <typename Write>
  void write_part(std::size_t begin, std::size_t end, std::uint64_t count, Write& write) {
    if (count == 0) return;
    stop_if_interrupted();
    std::vector<Row> rows(count);
    std::vector<std::uint64_t> next(end - begin + 1, 0);
    for (std::size_t i = begin; i < end; ++i) next[i - begin + 1] = next[i - begin] + counts_[i];
    file_.for_each([&](const Row& row) {
      const std::uint64_t at = row[0] - first_;
      if (at >= begin && at < end && next[at - begin] < count) rows[next[at - begin]++] = row;
    });
    std::uint64_t first = 0;
    for (std::size_t i = begin; i < end; first = next[i++ - begin]) {
      if (next[i - begin] - first < 2) continue;
      const auto row = rows.begin();
      std::sort(row + static_cast<std::ptrdiff_t>(first), row + static_cast<std::ptrdiff_t>(next[i - begin]));
    }
    write(std::string_view(reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(Row)));
  }

  RowFile<Index> file_;
  std::uint64_t first_;
  std::vector<std::uint32_t> counts_;
  std::uint64_t most_;
};

}  // namespace

std::uint64_t RowsState::total() const { return std::accumulate(rows.begin(), rows.end(), std::uint64_t{0}); }

TriangleRows::TriangleRows(const Scratch& scratch, std::uint64_t points, std::uint64_t file_bytes)
    : scratch_(scratch), short_(points <= std::numeric_limits<std::uint32_t>::max()) {
  // Expect at most two triangles for each point. If points are in random order, files of small least indices get three
  // times the average number of triangles.
  const std::uint64_t bytes = 2 * points * row_bytes();
  constexpr std::uint64_t most_files = 4096, least_waiting = 24 * 64;
  const std::uint64_t all_waiting = file_bytes / 4;
  const std::uint64_t files =
      std::clamp<std::uint64_t>(2 * bytes / std::max<std::uint64_t>(file_bytes, 1) + 1, 1,
                                std::clamp<std::uint64_t>(all_waiting / least_waiting, 1, most_files));
  most_waiting_ = std::clamp<std::uint64_t>(all_waiting / files / 24 * 24, least_waiting, buffer_bytes);
  width_ = std::max<std::uint64_t>((points + files - 1) / files, 1);
  buckets_.resize((points + width_ - 1) / width_);
}

void TriangleRows::resume(const RowsState& state) {
  if (state.rows.size() != buckets_.size() || state.sums.size() != buckets_.size())
    begin_anew(scratch_.folder(), "other files of triangles than were written", scratch_.folder());
  for (std::size_t i = 0; i < buckets_.size(); ++i) {
    buckets_[i].rows = state.rows[i];
    buckets_[i].sum = state.sums[i];
    const std::string path = scratch_.rows(i);
    ScratchFile file(path, ScratchFile::Mode::append);
    const std::uint64_t size = state.rows[i] * row_bytes();
    if (file.size() < size)
      begin_anew(path, std::to_string(file.size()) + " bytes, expected at least " + std::to_string(size),
                 scratch_.folder());
    file.cut(size);
  }
}

void TriangleRows::add(std::span<const TriangleRow> triangles) {
  for (const TriangleRow& row : triangles) {
    Bucket& bucket = buckets_[row[0] / width_];
    if (short_) {
      const std::uint32_t narrow[3] = {static_cast<std::uint32_t>(row[0]), static_cast<std::uint32_t>(row[1]),
                                       static_cast<std::uint32_t>(row[2])};
      bucket.waiting.append(reinterpret_cast<const char*>(narrow), sizeof narrow);
    } else {
      bucket.waiting.append(reinterpret_cast<const char*>(row.data()), sizeof row);
    }
    bucket.sum += number_of(row);
    ++bucket.rows;
    if (bucket.waiting.size() >= most_waiting_) write(static_cast<std::size_t>(&bucket - buckets_.data()));
  }
}

void TriangleRows::write(std::size_t bucket) {
  std::string& waiting = buckets_[bucket].waiting;
  if (waiting.empty()) return;
  ScratchFile(scratch_.rows(bucket), ScratchFile::Mode::append).write(waiting);
  waiting.clear();
}

RowsState TriangleRows::flush() {
  RowsState state;
  for (std::size_t i = 0; i < buckets_.size(); ++i) {
    write(i);
    state.rows.push_back(buckets_[i].rows);
    state.sums.push_back(buckets_[i].sum);
  }
  return state;
}

void TriangleRows::sorted(std::uint64_t memory, const std::function<void(std::string_view bytes)>& write) const {
  const auto sort = [&]<typename Index>(std::size_t i, Index) {
    const auto require_same = [&](std::uint64_t rows, std::uint64_t sum) {
      if (rows == buckets_[i].rows && sum == buckets_[i].sum) return;
      begin_anew(scratch_.rows(i), "other triangles than were written", scratch_.folder());
    };
    std::uint64_t sum = 0;
    // Sort all rows if few indices are the least of a triangle. Sorting is cheaper then than a counter for each index.
    if (4 * buckets_[i].rows < width_ && buckets_[i].rows * row_bytes() < std::max(memory / 2, few_bytes)) {
      const auto rows = sorted_rows<Index>(scratch_.rows(i), sum);
      require_same(rows.size(), sum);
      return write(std::string_view(reinterpret_cast<const char*>(rows.data()), rows.size() * row_bytes()));
    }
    BucketSort<Index> bucket(scratch_.rows(i), i * width_, (i + 1) * width_, memory);
    std::uint64_t rows = 0;
    sum = bucket.count(rows);
    require_same(rows, sum);
    bucket.write(write);
  };
  for (std::size_t i = 0; i < buckets_.size(); ++i) {
    if (buckets_[i].rows == 0) continue;
    short_ ? sort(i, std::uint32_t{}) : sort(i, std::uint64_t{});
  }
}

}  // namespace rbpa::app
