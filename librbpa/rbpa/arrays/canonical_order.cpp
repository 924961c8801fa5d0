#include "rbpa/arrays/canonical_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <numeric>
#include <type_traits>
#include <utility>

#include "meshops/core/large_pages.h"
#include "rbpa/parallel/in_order.h"

namespace rbpa {
namespace {

constexpr std::size_t corners_per_bucket = 1u << 11;  // whose triangles, up to six each, fit a cache of half a megabyte
constexpr std::size_t max_buckets = 1u << 11;         // whose ends fit the nearest cache

/// Smallest corners are shifted by so much to be numbers of buckets.
int bucket_shift(std::size_t bound) {
  int shift = std::countr_zero(corners_per_bucket);
  while ((bound >> shift) >= max_buckets) ++shift;
  return shift;
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
NumberedRest rest_of(const NumberedTriple& t) { return {key_of(t.corners), t.number}; }
Triple corners_of(std::size_t first, std::uint64_t key) {
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)};
}

/// Which of two comes first is a toss of a coin: no branch.
void put_in_order(Rest& a, Rest& b) {
  const std::uint64_t first = std::min(a.key, b.key), second = std::max(a.key, b.key);
  a.key = first;
  b.key = second;
}
void put_in_order(NumberedRest& a, NumberedRest& b) {
  const std::uint64_t all_if_behind = -std::uint64_t{b.key < a.key};
  const std::uint64_t keys = (a.key ^ b.key) & all_if_behind;
  const std::uint32_t numbers = (a.number ^ b.number) & static_cast<std::uint32_t>(all_if_behind);
  a = {a.key ^ keys, a.number ^ numbers};
  b = {b.key ^ keys, b.number ^ numbers};
}

/// Sorting networks: pairs of places to be put in order, one after the other.
template <std::size_t size>
struct Network;
template <>
struct Network<4> {
  static constexpr unsigned char pairs[][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}, {1, 2}};
};
template <>
struct Network<8> {
  static constexpr unsigned char pairs[][2] = {{0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6},
                                               {3, 7}, {0, 1}, {2, 3}, {4, 5}, {6, 7}, {2, 4}, {3, 5},
                                               {1, 4}, {3, 6}, {1, 2}, {3, 4}, {5, 6}};
};
constexpr std::size_t max_network = 8;

/// Sorts a few rests as if they were `size`, the others being greater than all: how many there are changes from corner
/// to corner, and a branch for it would be foretold wrongly. Reads `size` of them.
template <std::size_t size, typename R>
void sort_few(const R* few, std::size_t count, std::array<R, max_network>& sorted) {
  for (std::size_t i = 0; i < size; ++i) {
    sorted[i] = few[i];
    sorted[i].key |= -std::uint64_t{i >= count};
  }
  [&]<std::size_t... step>(std::index_sequence<step...>) {
    constexpr auto& pairs = Network<size>::pairs;
    (put_in_order(sorted[pairs[step][0]], sorted[pairs[step][1]]), ...);
  }
  (std::make_index_sequence<std::size(Network<size>::pairs)>());
}

/// Sorts the triangles at one smallest corner: two on average, and up to a dozen where it is one of the least of all.
/// Returns: where they are then: in place, or in `few`.
template <typename R>
R* sort_star(R* star, std::size_t count, std::array<R, max_network>& few) {
  if (count > max_network) {
    std::sort(star, star + count, [](const R& a, const R& b) { return a.key < b.key; });
    return star;
  }
  if (count <= 4)
    sort_few<4>(star, count, few);
  else
    sort_few<max_network>(star, count, few);
  return few.data();
}

}  // namespace

/// One bucket while it is sorted.
template <typename Item>
struct CanonicalOrder<Item>::Workspace {
  using Rests = std::vector<decltype(rest_of(Item()))>;
  Rests rests;                      // by smallest corner, and max_network more that are read
  std::vector<std::uint32_t> next;  // of each smallest corner, where its next one goes
  meshops::FreshVector<Triple> triples;
  meshops::FreshVector<std::uint32_t> numbers;
  std::size_t count = 0;
};

template <typename Item>
CanonicalOrder<Item>::CanonicalOrder(std::size_t bound, std::size_t most, std::size_t threads)
    : bound_(bound), shift_(bucket_shift(bound)), buckets_((bound >> shift_) + 1) {
  // All but the last block of each bucket of each writer are full.
  const std::size_t blocks = most / items_in_block + threads * buckets_;
  pool_.resize(blocks * items_in_block);
}

template <typename Item>
CanonicalOrder<Item>::Writer::Writer(CanonicalOrder& order)
    : order_(&order), items_(order.pool_.data()), shift_(order.shift_) {
  for (std::size_t bucket = 0; bucket < order.buckets_; ++bucket) next_.push_back(begin_block(bucket));
}

template <typename Item>
std::size_t CanonicalOrder<Item>::Writer::begin_block(std::size_t bucket) {
  const std::size_t first = items_in_block * order_->blocks_++;
  blocks_.push_back({bucket, first});
  return first;
}

template <typename Item>
typename CanonicalOrder<Item>::Writer* CanonicalOrder<Item>::take() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return writers_.emplace_back(new Writer(*this)).get();
  Writer* const writer = idle_.back();
  idle_.pop_back();
  return writer;
}

template <typename Item>
std::vector<std::vector<typename CanonicalOrder<Item>::Run>> CanonicalOrder<Item>::runs() const {
  std::vector<std::vector<Run>> of_bucket(buckets_);
  for (const auto& writer : writers_)
    for (const auto& [bucket, first] : writer->blocks_) {
      const std::size_t next = writer->next_[bucket];
      const bool is_last = first <= next && next < first + items_in_block;
      of_bucket[bucket].push_back({pool_.data() + first, is_last ? next - first : items_in_block});
    }
  return of_bucket;
}

/// By counting the smallest corners.
template <typename Item>
void CanonicalOrder<Item>::sort(const std::vector<Run>& bucket, std::size_t first_corner, std::size_t corners,
                                Workspace& workspace) const {
  auto& [rests, next, triples, numbers, count] = workspace;
  count = 0;
  for (const Run& run : bucket) count += run.count;
  if (triples.size() < count + max_network) {
    rests.resize(count + max_network);
    triples.resize(count + max_network);
    if constexpr (std::is_same_v<Item, NumberedTriple>) numbers.resize(count + max_network);
  }
  next.assign(corners + 1, 0);
  for (const auto& [items, size] : bucket)
    for (std::size_t i = 0; i < size; ++i) ++next[smallest(items[i]) - first_corner + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (const auto& [items, size] : bucket)
    for (std::size_t i = 0; i < size; ++i) rests[next[smallest(items[i]) - first_corner]++] = rest_of(items[i]);

  std::array<typename Workspace::Rests::value_type, max_network> few;
  std::size_t first = 0;
  for (std::size_t c = 0; c < corners; ++c) {
    const std::size_t last = next[c];  // all of c are put, so this is where those of c + 1 begin
    const auto* sorted = sort_star(rests.data() + first, last - first, few);
    for (; first < last; ++first, ++sorted) {
      triples[first] = corners_of(first_corner + c, sorted->key);
      if constexpr (std::is_same_v<Item, NumberedTriple>) numbers[first] = sorted->number;
    }
  }
}

template <typename Item>
std::vector<Triple> CanonicalOrder<Item>::sorted(Threads& threads, std::uint32_t* rank) {
  const std::vector<std::vector<Run>> of_bucket = runs();
  std::vector<std::size_t> start = {0};
  for (const auto& bucket : of_bucket) {
    start.push_back(start.back());
    for (const Run& run : bucket) start.back() += run.count;
  }
  std::vector<Triple> all;
  all.reserve(start.back());
  meshops::prefer_large_pages(all.data(), start.back() * sizeof(Triple));
  const std::size_t width = std::size_t{1} << shift_;
  in_order<Workspace>(
      threads, buckets_,
      [&](std::size_t b, Workspace& workspace) {
        const std::size_t first_corner = b << shift_;
        sort(of_bucket[b], first_corner, std::min(width, bound_ - std::min(bound_, first_corner)), workspace);
        if constexpr (std::is_same_v<Item, NumberedTriple>)
          for (std::size_t i = 0; i < workspace.count; ++i)
            rank[workspace.numbers[i]] = static_cast<std::uint32_t>(start[b] + i);
      },
      [&](std::size_t, Workspace& workspace) {
        const auto first = workspace.triples.begin();
        all.insert(all.end(), first, first + static_cast<std::ptrdiff_t>(workspace.count));
      },
      [](std::size_t, Workspace&) {});
  return all;
}

template class CanonicalOrder<Triple>;
template class CanonicalOrder<NumberedTriple>;

}  // namespace rbpa
