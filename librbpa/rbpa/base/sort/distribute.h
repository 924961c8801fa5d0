// What: distributes items over buckets: the first pass of a bucket sort.
// Law:  items of one bucket keep their order, so the result does not depend on the number of threads.
// Cost: linear in the items, and in the buckets of each part.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/parallel/threads.h"

namespace rbpa {

/// Calls put(i, place) for each of the items 0 … `items` − 1; a thread processes `part` items at a time. `place` is the
/// number of items in lower buckets plus the number of earlier items in the bucket of item i. Calls bucket_of(i) twice
/// for each item, as storing the result would take longer. Requires: bucket_of(i) < `buckets`.
/// Returns: the first place of each bucket, and the end.
template <typename BucketOf, typename Put>
std::vector<std::uint32_t> distribute(std::size_t items, std::size_t buckets, std::size_t part, Threads& threads,
                                      const BucketOf& bucket_of, const Put& put) {
  const std::size_t parts = (items + part - 1) / part;
  // For each part, the place of the part's next item in each bucket.
  std::vector<std::uint32_t> place(parts * buckets, 0);
  for_each_part(threads, items, part, [&](std::size_t first, std::size_t last) {
    std::uint32_t* const count = &place[first / part * buckets];
    for (std::size_t i = first; i < last; ++i) ++count[bucket_of(i)];
  });
  std::vector<std::uint32_t> start;
  start.reserve(buckets + 1);
  std::uint32_t sum = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    start.push_back(sum);
    for (std::size_t at = bucket; at < place.size(); at += buckets) {
      const std::uint32_t count = place[at];
      place[at] = sum;
      sum += count;
    }
  }
  start.push_back(sum);
  for_each_part(threads, items, part, [&](std::size_t first, std::size_t last) {
    std::uint32_t* const next = &place[first / part * buckets];
    for (std::size_t i = first; i < last; ++i) put(i, next[bucket_of(i)]++);
  });
  return start;
}

}  // namespace rbpa
