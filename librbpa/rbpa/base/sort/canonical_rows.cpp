#include "rbpa/base/sort/canonical_rows.h"

#include <algorithm>

#include "rbpa/base/sort/distribute.h"

namespace rbpa {
namespace {

struct NumberedRow {
  Row row;
  std::uint32_t number;
  friend bool operator<(const NumberedRow& a, const NumberedRow& b) { return a.row < b.row; }
};

constexpr std::size_t rows_in_bucket = 1u << 13, rows_at_a_time = 1u << 18;  // 160 kilobytes
constexpr std::size_t max_buckets = 1u << 11;

/// Rows of one bucket, whose first numbers are in [first, first + range).
void sort_bucket(const NumberedRow* begin, std::size_t count, std::size_t first, std::size_t range, Row* rows,
                 std::uint32_t* numbers) {
  std::vector<std::uint32_t> next(range + 1, 0);
  for (std::size_t i = 0; i < count; ++i) ++next[begin[i].row[0] - first + 1];
  for (std::size_t k = 1; k <= range; ++k) next[k] += next[k - 1];
  std::vector<NumberedRow> sorted(count);
  const std::vector<std::uint32_t> start = next;
  for (std::size_t i = 0; i < count; ++i) sorted[next[begin[i].row[0] - first]++] = begin[i];
  for (std::size_t k = 0; k < range; ++k) std::sort(sorted.begin() + start[k], sorted.begin() + start[k + 1]);
  for (std::size_t i = 0; i < count; ++i) {
    rows[i] = sorted[i].row;
    numbers[i] = sorted[i].number;
  }
}

}  // namespace

meshops::FreshVector<std::uint32_t> sort_rows(std::vector<Row>& rows, std::size_t bound, Threads& threads) {
  std::size_t shift = 0;
  const std::size_t wanted = std::min(max_buckets, rows.size() / rows_in_bucket + 1);
  while ((bound >> shift) >= wanted) ++shift;
  const std::size_t buckets = (bound >> shift) + 1;
  meshops::FreshVector<NumberedRow> parted(rows.size());
  const std::vector<std::uint32_t> start = distribute(
      rows.size(), buckets, rows_at_a_time, threads, [&](std::size_t i) { return std::size_t{rows[i][0]} >> shift; },
      [&](std::size_t i, std::uint32_t at) {
        parted[at] = {rows[i], static_cast<std::uint32_t>(i)};
      });
  meshops::FreshVector<std::uint32_t> from(rows.size());
  for_each_index(threads, buckets, [&](std::size_t b) {
    sort_bucket(parted.data() + start[b], start[b + 1] - start[b], b << shift, std::size_t{1} << shift,
                rows.data() + start[b], from.data() + start[b]);
  });
  return from;
}

}  // namespace rbpa
