// What: brings triangles into canonical order: lexicographic, each triangle from its smallest corner on.
// Law:  the order depends on the triangles only, not on the order in which they come or on threads.
// How:  a triangle is put into a bucket as soon as it is added. A bucket covers a range of smallest corners. It is a
//       list of blocks of memory that all buckets share, so its size need not be known in advance, and no item moves:
//
//           slab   | 0 | 1 | 2 | 0 | 0 | 1 | 0 | 2 | ...     each block of a slab, shown as its bucket's number
//
//       In the end each bucket is sorted, in general within a cache, and appended to the bucket before.
// Cost: linear; about as much memory as the triangles take, in addition to the result.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "meshops/patch/patch.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle.h"

namespace rbpa {

/// A triangle, and its position in a list.
struct NumberedTriangle {
  Triangle corners;
  std::uint32_t number;
};

/// Returns the names of a triangle's corners, rotated so that the least comes first. The code has no branch, as the
/// position of the least name cannot be predicted.
inline Triangle from_least(std::span<const std::uint32_t> names, const std::array<meshops::Site, 3>& corner) {
  const std::uint32_t a = names[corner[0]], b = names[corner[1]], c = names[corner[2]];
  const std::uint32_t b_first = (b < a) & (b < c), c_first = (c < a) & (c < b);
  const std::uint32_t turn_by_1 = -b_first, turn_by_2 = -c_first;  // all bits, or none
  const std::uint32_t first = a ^ ((a ^ b) & turn_by_1) ^ ((a ^ c) & turn_by_2),
                      second = b ^ ((b ^ c) & turn_by_1) ^ ((b ^ a) & turn_by_2);
  return {first, second, a ^ b ^ c ^ first ^ second};
}

/// Calls visit(Triangle) for each triangle of a patch, in order, with the names of the corners, the least first.
template <typename Visit>
void for_each_triangle(const meshops::Patch& patch, std::span<const std::uint32_t> names, Visit visit) {
  constexpr std::size_t ahead = 32;  // names are prefetched this many triangles before
  const std::size_t count = patch.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    for (const meshops::Site corner : patch.triangles[std::min(t + ahead, count - 1)])
      __builtin_prefetch(&names[corner]);
    visit(from_least(names, patch.triangles[t]));
  }
}

/// A sorter of triangles. `Item` is Triangle, or NumberedTriangle.
template <typename Item>
class CanonicalOrder {
 public:
  /// Prepares for at most `most` triangles with corners below `bound`, from at most `threads` writers at a time.
  CanonicalOrder(std::size_t bound, std::size_t most, std::size_t threads);

  /// A writer of items, for one thread at a time. Requires: each item has its smallest corner first; not checked.
  class Writer {
   public:
    void add(const Item& item) {
      const std::size_t bucket = smallest(item) >> shift_;
      Open& open = open_[bucket];
      *open.next++ = item;
      __builtin_prefetch(open.next + items_ahead, 1);
      if (open.next == open.end) begin_block(bucket);
    }

   private:
    friend class CanonicalOrder;
    explicit Writer(CanonicalOrder& order);
    void begin_block(std::size_t bucket);

    /// A block that is not full: the place of the next item, and the end of the block.
    struct Open {
      Item *next, *end;
    };
    struct Block {
      std::size_t bucket;
      const Item* first;
    };
    CanonicalOrder* order_;
    int shift_;
    std::vector<Open> open_;     // one for each bucket
    std::vector<Block> blocks_;  // all blocks that were begun
  };

  /// Calls write(Writer&) with a writer that no other thread uses meanwhile. Requires: at most as many calls at a time
  /// as the constructor was given threads.
  template <typename Write>
  void with_writer(Write write) {
    Writer* const writer = take();
    write(*writer);
    const std::lock_guard lock(mutex_);
    idle_.push_back(writer);
  }

  /// Returns all triangles in order. No triangle may be added afterwards. Calls `checkpoint`, unless it is empty, after
  /// each bucket, one call at a time; `checkpoint` may throw.
  std::vector<Triangle> sorted(Threads& threads, const Checkpoint& checkpoint = {});
  /// Returns all triangles as sorted() does. Sets rank[n] to the position of triangle number n in the result.
  /// Requires: Item is NumberedTriangle; the numbers are 0, 1, 2 …, each once; `rank` has an entry for each number.
  std::vector<Triangle> sorted_with_ranks(Threads& threads, std::uint32_t* rank, const Checkpoint& checkpoint = {});
  /// Returns all triangles as sorted() does. Sets numbers[i] to the number of triangle i of the result; several
  /// triangles may have one number. Requires: Item is NumberedTriangle; `numbers` has an entry for each triangle.
  std::vector<Triangle> sorted_with_numbers(Threads& threads, std::uint32_t* numbers,
                                            const Checkpoint& checkpoint = {});
  /// Frees the memory of the added triangles.
  void end() { slabs_ = std::vector<meshops::FreshVector<Item>>(); }

 private:
  static constexpr std::size_t items_in_block = 256;  // 3 kilobytes
  static constexpr std::size_t items_ahead = 16;      // memory of a bucket is prefetched before it is written
  /// A contiguous part of a bucket.
  struct Run {
    const Item* first;
    std::size_t count;
  };
  struct Workspace;

  static std::size_t smallest(const Triangle& item) { return item[0]; }
  static std::size_t smallest(const NumberedTriangle& item) { return item.corners[0]; }
  Writer* take();
  Item* new_block();
  std::vector<std::vector<Run>> runs() const;
  template <typename PutNumbers>
  std::vector<Triangle> sort_all(Threads& threads, PutNumbers put_numbers, const Checkpoint& checkpoint) const;
  void sort(const std::vector<Run>& bucket, std::size_t first_corner, std::size_t corners, Workspace& workspace) const;

  std::size_t bound_;
  int shift_;
  std::size_t buckets_;
  std::size_t blocks_in_slab_;
  std::vector<meshops::FreshVector<Item>> slabs_;
  std::size_t blocks_left_ = 0;  // blocks left in the last slab
  std::mutex slabs_mutex_, mutex_;
  std::vector<std::unique_ptr<Writer>> writers_;
  std::vector<Writer*> idle_;
};

extern template class CanonicalOrder<Triangle>;
extern template class CanonicalOrder<NumberedTriangle>;

}  // namespace rbpa
