#include "rbpa/arrays/canonical_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "rbpa/parallel/in_order.h"

namespace rbpa {
namespace {

using Triple = TriangleList::Triple;

/// A triangle, and where it came from.
struct Numbered {
  Triple corners;
  std::uint32_t number;
};
const Triple& corners(const Triple& t) { return t; }
const Triple& corners(const Numbered& t) { return t.corners; }
void make(Triple& made, const Triple& t, std::size_t) { made = t; }
void make(Numbered& made, const Triple& t, std::size_t number) { made = {t, static_cast<std::uint32_t>(number)}; }

constexpr std::size_t part = 1u << 16;                // triangles that a thread puts into buckets at a time
constexpr std::size_t corners_per_bucket = 1u << 13;  // whose triangles fit a cache of half a megabyte
constexpr std::size_t max_buckets = 1u << 11;         // whose ends fit the nearest cache

/// The smallest corners are shifted by so much to be numbers of buckets.
int bucket_shift(std::size_t bound) {
  int shift = std::countr_zero(corners_per_bucket);
  while ((bound >> shift) >= max_buckets) ++shift;
  return shift;
}

template <typename Item>
struct Buckets {
  meshops::FreshVector<Item> items;
  std::vector<std::size_t> start;  // of each bucket, and the end
};

template <typename Item>
Buckets<Item> into_buckets(const meshops::FreshVector<Triple>& triangles, std::size_t bound, int shift,
                           Threads& threads) {
  const std::size_t n = triangles.size(), buckets = (bound >> shift) + 1, parts = (n + part - 1) / part;
  std::vector<std::uint32_t> place(parts * buckets, 0);
  for_each_part(threads, n, part, [&](std::size_t first, std::size_t last) {
    std::uint32_t* const count = place.data() + first / part * buckets;
    for (std::size_t t = first; t < last; ++t) ++count[triangles[t][0] >> shift];
  });
  Buckets<Item> sorted;
  sorted.start.resize(buckets + 1);
  std::uint32_t sum = 0;
  for (std::size_t b = 0; b < buckets; ++b) {
    sorted.start[b] = sum;
    for (std::size_t p = 0; p < parts; ++p) {
      std::uint32_t& at = place[p * buckets + b];
      sum += at;
      at = sum - at;
    }
  }
  sorted.start[buckets] = sum;
  sorted.items.resize(n);
  for_each_part(threads, n, part, [&](std::size_t first, std::size_t last) {
    std::uint32_t* const next = place.data() + first / part * buckets;
    for (std::size_t t = first; t < last; ++t) make(sorted.items[next[triangles[t][0] >> shift]++], triangles[t], t);
  });
  return sorted;
}

/// By counting the smallest corners, few of which have more than three triangles.
template <typename Item>
void sort_bucket(Item* items, std::size_t count, std::size_t first_corner, std::size_t corner_count,
                 std::vector<Item>& sorted, std::vector<std::uint32_t>& next) {
  sorted.resize(count);
  next.assign(corner_count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) ++next[corners(items[i])[0] - first_corner + 1];
  for (std::size_t c = 1; c <= corner_count; ++c) next[c] += next[c - 1];
  for (std::size_t i = 0; i < count; ++i) sorted[next[corners(items[i])[0] - first_corner]++] = items[i];
  const auto before = [](const Item& a, const Item& b) { return corners(a)[1] < corners(b)[1]; };
  std::size_t first = 0;
  for (std::size_t c = 0; c < corner_count; ++c) {
    const std::size_t last = next[c];
    // A star has a dozen at most, but for that of a hub. No two have the first side in common.
    if (last - first > 16) {
      std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(first), sorted.begin() + static_cast<std::ptrdiff_t>(last),
                before);
    } else {
      for (std::size_t i = first + 1; i < last; ++i) {
        const Item item = sorted[i];
        std::size_t at = i;
        for (; at > first && before(item, sorted[at - 1]); --at) sorted[at] = sorted[at - 1];
        sorted[at] = item;
      }
    }
    first = last;
  }
  std::copy_n(sorted.begin(), count, items);
}

template <typename Item>
void sort_buckets(Buckets<Item>& buckets, std::size_t bound, int shift, Threads& threads) {
  struct Workspace {
    std::vector<Item> sorted;
    std::vector<std::uint32_t> next;
  };
  const std::size_t width = std::size_t{1} << shift;
  const auto nothing = [](std::size_t, Workspace&) {};
  in_order<Workspace>(
      threads, buckets.start.size() - 1,
      [&](std::size_t b, Workspace& workspace) {
        const std::size_t first = buckets.start[b], first_corner = b << shift;
        sort_bucket(buckets.items.data() + first, buckets.start[b + 1] - first, first_corner,
                    std::min(width, bound - std::min(bound, first_corner)), workspace.sorted, workspace.next);
      },
      nothing, nothing);
}

}  // namespace

void sort_canonically(meshops::FreshVector<Triple>& triangles, std::size_t bound, Threads& threads,
                      meshops::FreshVector<std::uint32_t>* rank) {
  const int shift = bucket_shift(bound);
  if (rank == nullptr) {
    auto buckets = into_buckets<Triple>(triangles, bound, shift, threads);
    triangles = {};
    sort_buckets(buckets, bound, shift, threads);
    triangles = std::move(buckets.items);
    return;
  }
  auto buckets = into_buckets<Numbered>(triangles, bound, shift, threads);
  sort_buckets(buckets, bound, shift, threads);
  rank->resize(triangles.size());
  for_each_part(threads, triangles.size(), part, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      triangles[i] = buckets.items[i].corners;
      (*rank)[buckets.items[i].number] = static_cast<std::uint32_t>(i);
    }
  });
}

}  // namespace rbpa
