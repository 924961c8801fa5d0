#include "rbpa/base/sort/distribute.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "rbpa/base/arrays/distinct.h"
#include "support/random.h"

using rbpa::Threads;

TEST_SUITE_BEGIN("parallel");

TEST_CASE("distribute() puts items bucket by bucket and keeps the order in each, with any number of threads") {
  rbpa_test::Random random(11);
  for (const std::size_t items : {0u, 1u, 99u, 100u, 101u, 20000u})
    for (const int buckets : {1, 2, 7, 300})
      for (const unsigned threads : {1u, 2u, 5u}) {
        CAPTURE(items);
        CAPTURE(buckets);
        CAPTURE(threads);
        std::vector<std::size_t> bucket(items);
        for (std::size_t& b : bucket) b = static_cast<std::size_t>(random.integer(0, buckets - 1));
        std::vector<std::size_t> expected(items), found(items, items);
        std::iota(expected.begin(), expected.end(), std::size_t{0});
        std::stable_sort(expected.begin(), expected.end(),
                         [&](std::size_t i, std::size_t j) { return bucket[i] < bucket[j]; });
        Threads some(threads);
        const std::vector<std::uint32_t> start = rbpa::distribute(
            items, static_cast<std::size_t>(buckets), 100, some, [&](std::size_t i) { return bucket[i]; },
            [&](std::size_t i, std::uint32_t place) { found[place] = i; });
        CHECK(found == expected);
        REQUIRE(start.size() == static_cast<std::size_t>(buckets) + 1);
        for (std::size_t b = 0; b < start.size(); ++b)
          CHECK(static_cast<std::ptrdiff_t>(start[b]) ==
                std::count_if(bucket.begin(), bucket.end(), [&](std::size_t other) { return other < b; }));
      }
}

TEST_CASE("distinct points are those that are not duplicates") {
  const auto distinct = [](std::size_t points, const std::vector<rbpa::Duplicate>& duplicates) {
    std::vector<std::uint32_t> found;
    rbpa::for_each_distinct(points, duplicates, [&](std::uint32_t i) { found.push_back(i); });
    return found;
  };
  using Indices = std::vector<std::uint32_t>;
  CHECK(distinct(0, {}) == Indices{});
  CHECK(distinct(3, {}) == Indices{0, 1, 2});
  CHECK(distinct(6, {{1, 0}, {2, 0}, {5, 3}}) == Indices{0, 3, 4});
}

TEST_SUITE_END();
