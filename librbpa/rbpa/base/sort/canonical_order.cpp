#include "rbpa/base/sort/canonical_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>

#include "meshops/core/large_pages.h"
#include "rbpa/base/parallel/in_order.h"

namespace rbpa {
namespace {

// With up to six triangles for each smallest corner, a bucket of this size fits a cache of half a megabyte.
constexpr std::size_t corners_per_bucket = 1u << 11;
// Slabs are so small that the allocator can reuse freed ones, which the system need not clear again.
constexpr std::size_t max_blocks_in_slab = 1u << 12;  // 12 megabytes; 16 with numbers
constexpr std::size_t max_buckets = 1u << 11;         // so that the write positions of all buckets fit the L1 cache

/// Returns the number of bits by which a smallest corner is shifted to give its bucket number. The number of buckets is
/// limited, so that few blocks stay nearly empty.
int bucket_shift(std::size_t bound, std::size_t most_open_blocks) {
  int shift = std::countr_zero(corners_per_bucket);
  while ((bound >> shift) >= std::min(max_buckets, most_open_blocks + 1)) ++shift;
  return shift;
}

/// An item without its smallest corner: the second and third corner as one key, which one comparison orders.
struct Rest {
  std::uint64_t key;
};
struct NumberedRest {
  std::uint64_t key;
  std::uint32_t number;
};
std::uint64_t key_of(const Triangle& t) { return std::uint64_t{t[1]} << 32 | t[2]; }
Rest rest_of(const Triangle& t) { return {key_of(t)}; }
NumberedRest rest_of(const NumberedTriangle& t) { return {key_of(t.corners), t.number}; }
Triangle corners_of(std::size_t first, std::uint64_t key) {
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)};
}

/// Returns all bits set if b comes before a, otherwise 0. A mask avoids a branch, which would be mispredicted.
/// (Compilers turn a choice between two values into a branch if the next choice depends on the result.)
template <typename R>
std::uint64_t all_if_behind(const R& a, const R& b) {
  return -std::uint64_t{b.key < a.key};
}
void put_in_order(Rest& a, Rest& b) {
  const std::uint64_t change = (a.key ^ b.key) & all_if_behind(a, b);
  a.key ^= change;
  b.key ^= change;
}
void put_in_order(NumberedRest& a, NumberedRest& b) {
  const std::uint64_t all = all_if_behind(a, b), change = (a.key ^ b.key) & all;
  const std::uint32_t change_number = (a.number ^ b.number) & static_cast<std::uint32_t>(all);
  a = {a.key ^ change, a.number ^ change_number};
  b = {b.key ^ change, b.number ^ change_number};
}

/// A sorting network: the pairs of positions whose entries are put in order, one pair after the other.
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

/// Sorts `count` ≤ size rests, and calls put(place, rest) for places 0 … size − 1. Entries from `count` on get the
/// greatest key, and are sorted and put as well: `count` changes from corner to corner, so a branch on `count` would
/// be mispredicted.
template <std::size_t size, typename R, typename Put>
void put_few(const R* few, std::size_t count, Put put) {
  std::array<R, size> r;
  for (std::size_t i = 0; i < size; ++i) {
    r[i] = few[i];
    r[i].key |= -std::uint64_t{i >= count};
  }
  [&]<std::size_t... step>(std::index_sequence<step...>) {
    constexpr auto& pairs = Network<size>::pairs;
    (put_in_order(r[pairs[step][0]], r[pairs[step][1]]), ...);
  }
  (std::make_index_sequence<std::size(Network<size>::pairs)>());
  for (std::size_t i = 0; i < size; ++i) put(i, r[i]);
}

/// Sorts the triangles with one smallest corner (two on average, seldom a dozen), and calls put(place, rest) for each.
/// For up to four or eight triangles, calls put() for all four or eight places; those after the last triangle get
/// meaningless rests. Requires: at least max_network entries can be read from `star` on.
template <typename R, typename Put>
void put_star(R* star, std::size_t count, Put put) {
  if (count <= 4) return put_few<4>(star, count, put);
  if (count <= max_network) return put_few<max_network>(star, count, put);
  std::sort(star, star + count, [](const R& a, const R& b) { return a.key < b.key; });
  for (std::size_t i = 0; i < count; ++i) put(i, star[i]);
}

}  // namespace

/// The memory for sorting one bucket.
template <typename Item>
struct CanonicalOrder<Item>::Workspace {
  using Rests = std::vector<decltype(rest_of(Item()))>;
  Rests rests;                      // by smallest corner; then max_network unused entries, which put_star() reads
  std::vector<std::uint32_t> next;  // for each smallest corner, the position of its next triangle
  meshops::FreshVector<Triangle> triples;
  meshops::FreshVector<std::uint32_t> numbers;
  std::size_t count = 0;
};

template <typename Item>
CanonicalOrder<Item>::CanonicalOrder(std::size_t bound, std::size_t most, std::size_t threads)
    : bound_(bound),
      shift_(bucket_shift(bound, most / 4 / (threads * items_in_block))),
      buckets_((bound >> shift_) + 1),
      // All but the last block of each bucket of each thread are full.
      blocks_in_slab_(std::min(max_blocks_in_slab, most / items_in_block + threads * buckets_)) {}

template <typename Item>
CanonicalOrder<Item>::Writer::Writer(CanonicalOrder& order)
    : order_(&order), shift_(order.shift_), open_(order.buckets_) {
  for (std::size_t bucket = 0; bucket < order.buckets_; ++bucket) begin_block(bucket);
}

template <typename Item>
void CanonicalOrder<Item>::Writer::begin_block(std::size_t bucket) {
  Item* const first = order_->new_block();
  blocks_.push_back({bucket, first});
  open_[bucket] = {first, first + items_in_block};
}

template <typename Item>
Item* CanonicalOrder<Item>::new_block() {
  const std::lock_guard lock(slabs_mutex_);
  if (blocks_left_ == 0) {
    slabs_.emplace_back(items_in_block * blocks_in_slab_);
    blocks_left_ = blocks_in_slab_;
  }
  return slabs_.back().data() + items_in_block * (blocks_in_slab_ - blocks_left_--);
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
      const auto& open = writer->open_[bucket];
      const bool is_open = open.end == first + items_in_block;
      of_bucket[bucket].push_back({first, is_open ? static_cast<std::size_t>(open.next - first) : items_in_block});
    }
  return of_bucket;
}

/// Sorts a bucket: by counting the smallest corners, then the few triangles of each smallest corner.
template <typename Item>
void CanonicalOrder<Item>::sort(const std::vector<Run>& bucket, std::size_t first_corner, std::size_t corners,
                                Workspace& workspace) const {
  auto& rests = workspace.rests;
  auto& next = workspace.next;
  auto& triples = workspace.triples;
  auto& numbers = workspace.numbers;
  std::size_t count = 0;
  for (const Run& run : bucket) count += run.count;
  if (triples.size() < count + max_network) {
    rests.resize(count + max_network);
    triples.resize(count + max_network);
    if constexpr (std::is_same_v<Item, NumberedTriangle>) numbers.resize(count + max_network);
  }
  workspace.count = count;
  next.assign(corners + 1, 0);
  for (std::size_t r = 0; r < bucket.size(); ++r) {
    const auto& [items, size] = bucket[r];
    const Item* const items_of_next = bucket[std::min(r + 1, bucket.size() - 1)].first;
    for (std::size_t i = 0; i < size; ++i) {
      __builtin_prefetch(items_of_next + i);
      ++next[smallest(items[i]) - first_corner + 1];
    }
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (const auto& [items, size] : bucket)
    for (std::size_t i = 0; i < size; ++i) rests[next[smallest(items[i]) - first_corner]++] = rest_of(items[i]);

  std::size_t first = 0;
  for (std::size_t c = 0; c < corners; ++c) {
    const std::size_t last = next[c];  // the end of the triangles of c, as all are in place
    put_star(rests.data() + first, last - first, [&](std::size_t i, const auto& rest) {
      triples[first + i] = corners_of(first_corner + c, rest.key);
      if constexpr (std::is_same_v<Item, NumberedTriangle>) numbers[first + i] = rest.number;
    });
    first = last;
  }
}

/// Sorts all buckets and returns the triangles in order. For each bucket, calls put_numbers(place, numbers) in any
/// thread: `numbers` are the numbers of the bucket's triangles in order, `place` is the position of the first in the
/// result.
template <typename Item>
template <typename PutNumbers>
std::vector<Triangle> CanonicalOrder<Item>::sort_all(Threads& threads, PutNumbers put_numbers,
                                                     const Checkpoint& checkpoint) const {
  const std::vector<std::vector<Run>> of_bucket = runs();
  std::vector<std::size_t> start = {0};
  for (const auto& bucket : of_bucket) {
    start.push_back(start.back());
    for (const Run& run : bucket) start.back() += run.count;
  }
  std::vector<Triangle> all;
  meshops::reserve_in_large_pages(all, start.back());
  const std::size_t width = std::size_t{1} << shift_;
  in_order<Workspace>(
      threads, buckets_,
      [&](std::size_t b, Workspace& workspace) {
        const std::size_t first_corner = b << shift_;
        sort(of_bucket[b], first_corner, std::min(width, bound_ - std::min(bound_, first_corner)), workspace);
        if constexpr (std::is_same_v<Item, NumberedTriangle>)
          put_numbers(start[b], std::span<const std::uint32_t>(workspace.numbers).first(workspace.count));
      },
      [&](std::size_t, Workspace& workspace) {
        const auto first = workspace.triples.begin();
        all.insert(all.end(), first, first + static_cast<std::ptrdiff_t>(workspace.count));
        if (checkpoint) checkpoint();
      },
      [](std::size_t, Workspace&) {});
  return all;
}

template <typename Item>
std::vector<Triangle> CanonicalOrder<Item>::sorted(Threads& threads, const Checkpoint& checkpoint) {
  return sort_all(
      threads, [](std::size_t, std::span<const std::uint32_t>) {}, checkpoint);
}

template <typename Item>
std::vector<Triangle> CanonicalOrder<Item>::sorted_with_ranks(Threads& threads, std::uint32_t* rank,
                                                              const Checkpoint& checkpoint) {
  return sort_all(
      threads,
      [rank](std::size_t place, std::span<const std::uint32_t> numbers) {
        for (std::size_t i = 0; i < numbers.size(); ++i) rank[numbers[i]] = static_cast<std::uint32_t>(place + i);
      },
      checkpoint);
}

template <typename Item>
std::vector<Triangle> CanonicalOrder<Item>::sorted_with_numbers(Threads& threads, std::uint32_t* numbers,
                                                                const Checkpoint& checkpoint) {
  return sort_all(
      threads,
      [numbers](std::size_t place, std::span<const std::uint32_t> some) {
        std::copy(some.begin(), some.end(), numbers + place);
      },
      checkpoint);
}

template class CanonicalOrder<Triangle>;
template class CanonicalOrder<NumberedTriangle>;

}  // namespace rbpa
