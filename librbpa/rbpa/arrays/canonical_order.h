// What: brings triangles into canonical order: lexicographic, each from its smallest corner on.
// Law:  the order depends on the triangles, and on nothing else: not on the order in which they come, nor on threads.
// How:  a triangle is put into a bucket as soon as it comes. A bucket takes a range of smallest corners, and is a list of
//       blocks of one pool, so that nobody has to know how many triangles it will have, and nothing is moved:
//
//           pool   | 0 | 1 | 2 | 0 | 0 | 1 | 0 | 2 | ...     a block has the number of its bucket here
//
//       In the end each bucket, which fits a cache, is sorted there and put behind the one before.
// Cost: linear; as much memory as the triangles take, beside the result.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/arrays/triple.h"
#include "rbpa/parallel/threads.h"

namespace rbpa {

/// `Item` is Triple, or NumberedTriple.
template <typename Item>
class CanonicalOrder {
 public:
  /// For at most `most` triangles, all corners being less than `bound`, which so many threads put in at a time.
  CanonicalOrder(std::size_t bound, std::size_t most, std::size_t threads);

  /// Puts items in, in one thread at a time.
  class Writer {
   public:
    void add(const Item& item) {
      const std::size_t bucket = smallest(item) >> shift_;
      std::size_t& next = next_[bucket];
      items_[next++] = item;
      __builtin_prefetch(&items_[next + items_ahead], 1);
      if (next % items_in_block == 0) next = begin_block(bucket);
    }

   private:
    friend class CanonicalOrder;
    explicit Writer(CanonicalOrder& order);
    std::size_t begin_block(std::size_t bucket);

    struct Block {
      std::size_t bucket, first;  // its first item
    };
    CanonicalOrder* order_;
    Item* items_;  // the pool
    int shift_;
    std::vector<std::size_t> next_;  // of each bucket, where the next item goes; never the end of a block
    std::vector<Block> blocks_;      // all that were begun
  };

  /// Calls write(Writer&) with a writer that nobody else has meanwhile. From as many threads at a time as were announced.
  template <typename Write>
  void with_writer(Write write) {
    Writer* const writer = take();
    write(*writer);
    const std::lock_guard lock(mutex_);
    idle_.push_back(writer);
  }

  /// All triangles in order. With `rank`, tells of each number where it went. Nothing is added afterwards.
  std::vector<Triple> sorted(Threads& threads, std::uint32_t* rank = nullptr);
  /// Frees the memory.
  void end() { pool_ = meshops::FreshVector<Item>(); }

 private:
  static constexpr std::size_t items_in_block = 256;  // 3 kilobytes
  static constexpr std::size_t items_ahead = 8;       // memory of a bucket is asked for before it is written
  /// A part of a bucket.
  struct Run {
    const Item* first;
    std::size_t count;
  };
  struct Workspace;

  static std::size_t smallest(const Triple& item) { return item[0]; }
  static std::size_t smallest(const NumberedTriple& item) { return item.corners[0]; }
  Writer* take();
  std::vector<std::vector<Run>> runs() const;
  void sort(const std::vector<Run>& bucket, std::size_t first_corner, std::size_t corners, Workspace& workspace) const;

  std::size_t bound_;
  int shift_;
  std::size_t buckets_;
  meshops::FreshVector<Item> pool_;  // longer than what will be in use, and not touched there
  std::atomic<std::size_t> blocks_ = 0;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Writer>> writers_;
  std::vector<Writer*> idle_;
};

extern template class CanonicalOrder<Triple>;
extern template class CanonicalOrder<NumberedTriple>;

}  // namespace rbpa
