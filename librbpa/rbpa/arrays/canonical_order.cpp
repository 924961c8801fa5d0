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

/// What is left of an item when its smallest corner is known: the second and third one, to be compared at once.
struct Rest {
  std::uint64_t key;
};
struct NumberedRest {
  std::uint64_t key;
  std::uint32_t number;
};
std::uint64_t key_of(const Triple& t) { return std::uint64_t{t[1]} << 32 | t[2]; }
Rest rest_of(const Triple& t) { return {key_of(t)}; }
NumberedRest rest_of(const Numbered& t) { return {key_of(t.corners), t.number}; }
Triple corners_of(std::size_t first, std::uint64_t key) {
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)};
}
void restore(Triple& t, std::size_t first, const Rest& rest) { t = corners_of(first, rest.key); }
void restore(Numbered& t, std::size_t first, const NumberedRest& rest) {
  t = {corners_of(first, rest.key), rest.number};
}

/// Which of two comes first is a toss of a coin: no branch.
template <typename R>
void put_in_order(R& a, R& b) {
  const R first = b.key < a.key ? b : a, second = b.key < a.key ? a : b;
  a = first;
  b = second;
}

/// The triangles at a smallest corner: two on average, a dozen seldom.
template <typename R>
void sort_star(R* star, std::size_t count) {
  switch (count) {
    case 0:
    case 1:
      return;
    case 4:
      put_in_order(star[0], star[1]);
      put_in_order(star[2], star[3]);
      put_in_order(star[0], star[2]);
      put_in_order(star[1], star[3]);
      put_in_order(star[1], star[2]);
      return;
    case 3:
      put_in_order(star[1], star[2]);
      put_in_order(star[0], star[1]);
      [[fallthrough]];
    case 2:
      put_in_order(star[count - 2], star[count - 1]);
      return;
    default:
      std::sort(star, star + count, [](const R& a, const R& b) { return a.key < b.key; });
  }
}

/// By counting the smallest corners.
template <typename Item, typename R>
void sort_bucket(Item* items, std::size_t count, std::size_t first_corner, std::size_t corner_count,
                 std::vector<R>& rests, std::vector<std::uint32_t>& next) {
  if (rests.size() < count) rests.resize(count);
  next.assign(corner_count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) ++next[corners(items[i])[0] - first_corner + 1];
  for (std::size_t c = 1; c <= corner_count; ++c) next[c] += next[c - 1];
  for (std::size_t i = 0; i < count; ++i) rests[next[corners(items[i])[0] - first_corner]++] = rest_of(items[i]);
  std::size_t first = 0;
  for (std::size_t c = 0; c < corner_count; ++c) {
    const std::size_t last = next[c];  // all of c are put, so this is where those of c + 1 begin
    sort_star(rests.data() + first, last - first);
    for (; first < last; ++first) restore(items[first], first_corner + c, rests[first]);
  }
}

template <typename Item>
void sort_buckets(Buckets<Item>& buckets, std::size_t bound, int shift, Threads& threads) {
  struct Workspace {
    std::vector<decltype(rest_of(Item()))> rests;
    std::vector<std::uint32_t> next;
  };
  const std::size_t width = std::size_t{1} << shift;
  const auto nothing = [](std::size_t, Workspace&) {};
  in_order<Workspace>(
      threads, buckets.start.size() - 1,
      [&](std::size_t b, Workspace& workspace) {
        const std::size_t first = buckets.start[b], first_corner = b << shift;
        sort_bucket(buckets.items.data() + first, buckets.start[b + 1] - first, first_corner,
                    std::min(width, bound - std::min(bound, first_corner)), workspace.rests, workspace.next);
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
