#include "rbpa/base/sort/canonical_rows.h"

#include <algorithm>

#include "meshops/core/large_pages.h"

namespace rbpa {
namespace {

struct NumberedRow {
  Row row;
  std::uint32_t number;
  friend bool operator<(const NumberedRow& a, const NumberedRow& b) { return a.row < b.row; }
};

void sort_few(std::vector<NumberedRow>& rows) {
  constexpr std::size_t few = 24;
  if (rows.size() > few) return std::sort(rows.begin(), rows.end());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const NumberedRow row = rows[i];
    std::size_t at = i;
    for (; at > 0 && row < rows[at - 1]; --at) rows[at] = rows[at - 1];
    rows[at] = row;
  }
}

}  // namespace

void resize_rows(std::vector<Row>& rows, std::size_t count, Threads& threads) {
  constexpr std::size_t page = 4096;
  rows.clear();
  meshops::reserve_in_large_pages(rows, count);
  auto* const memory = reinterpret_cast<std::byte*>(rows.data());
  for_each_part(threads, count * sizeof(Row), meshops::large_page, [&](std::size_t first, std::size_t last) {
    for (std::size_t at = first; at < last; at += page) memory[at] = std::byte{0};
  });
  rows.resize(count);
}

meshops::FreshVector<std::uint32_t> sort_rows(std::span<const Row> rows, std::size_t bound, Threads& threads,
                                              std::vector<Row>& sorted) {
  resize_rows(sorted, rows.size(), threads);
  meshops::FreshVector<std::uint32_t> end(bound + 1), order(rows.size()), place(rows.size());
  // Each thread sorts the rows of one range of first numbers; `range` is the length of the range.
  const std::size_t range = bound / threads.count() + 1;
  for_each_part(threads, bound, range, [&](std::size_t low, std::size_t high) {
    std::fill(end.begin() + static_cast<std::ptrdiff_t>(low), end.begin() + static_cast<std::ptrdiff_t>(high), 0);
    for (const Row& row : rows)
      if (row[0] - low < high - low) ++end[row[0]];
  });
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < bound; ++i) {
    const std::uint32_t count = end[i];
    end[i] = sum;
    sum += count;
  }
  for_each_part(threads, bound, range, [&](std::size_t low, std::size_t high) {
    for (std::uint32_t i = 0; i < rows.size(); ++i)
      if (rows[i][0] - low < high - low) order[end[rows[i][0]]++] = i;
  });
  constexpr std::size_t at_a_time = 1u << 13;
  for_each_part(threads, bound, at_a_time, [&](std::size_t low, std::size_t high) {
    std::vector<NumberedRow> group;
    std::uint32_t at = low == 0 ? 0 : end[low - 1], fetched = at;
    const std::uint32_t last = high == 0 ? 0 : end[high - 1];
    for (std::size_t first = low; first < high; ++first) {
      group.clear();
      // Rows of the next first numbers are scattered in memory: prefetching lets their cache misses overlap.
      for (const std::uint32_t ahead = std::min(end[first] + 48, last); fetched < ahead; ++fetched) {
        __builtin_prefetch(&rows[order[fetched]]);
        __builtin_prefetch(&place[order[fetched]], 1);
      }
      for (std::uint32_t i = at; i < end[first]; ++i) group.push_back({rows[order[i]], order[i]});
      sort_few(group);
      for (const NumberedRow& row : group) {
        sorted[at] = row.row;
        place[row.number] = at++;
      }
    }
  });
  return place;
}

}  // namespace rbpa
