#include "rbpa/base/parallel/in_order.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "meshops/core/disjoint_sets.h"

using rbpa::for_each_index;
using rbpa::for_each_part;
using rbpa::in_order;
using rbpa::Threads;

TEST_SUITE_BEGIN("parallel");

namespace {

constexpr unsigned thread_counts[] = {0, 1, 2, 3, 8};

struct Workspace {
  std::atomic<bool> in_use = false;
  std::vector<std::size_t> numbers;
};

/// Takes a different time for each i, so that items overtake each other.
std::size_t slow_square(std::size_t i) {
  std::size_t sum = 0;
  for (std::size_t k = 0; k < (i * 7919 % 13) * 2000 + 1; ++k) sum += (k * k + i) % 3;
  return i * i + 0 * sum;
}

}  // namespace

TEST_CASE("numbers joined by several threads are in the sets that one thread makes, and rings have their members") {
  constexpr std::uint32_t size = 100'000;
  for (const std::uint32_t step : {0u, 1u, 7u, 49'999u, 50'000u}) {  // with 0, all threads merge into one set
    meshops::DisjointSets expected(size);
    meshops::MemberRings rings(size);
    const auto other = [&](std::size_t i) {
      return step == 0 ? size - 1 : static_cast<std::uint32_t>((i * i % 11 * 13 + i + step) % size);
    };
    for (std::uint32_t i = 0; i < size; ++i)
      if (i % 5 != 0 && expected.find(i) != expected.find(other(i))) {
        expected.join(i, other(i));
        rings.join(i, other(i));
      }
    for (const unsigned count : thread_counts) {
      CAPTURE(count);
      Threads threads(count);
      meshops::DisjointSets sets(size);
      for_each_part(threads, size, 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
          if (const auto i = static_cast<std::uint32_t>(size - 1 - k); i % 5 != 0) sets.join_among_threads(i, other(i));
      });
      bool are_same = true;
      for (std::uint32_t i = 0; i < size; ++i) are_same = are_same && sets.find(i) == expected.find(i);
      CHECK(are_same);
    }
    std::size_t members = 0, strangers = 0;
    for (std::uint32_t i = 0; i < size; ++i)
      if (expected.is_least(i))
        rings.for_each(i, [&](std::uint32_t member) {
          ++members;
          strangers += expected.find(member) != i ? 1u : 0u;
        });
    CHECK(members == size);
    CHECK(strangers == 0);
  }
}

TEST_CASE("every item is processed, joined in order and finished once, in one workspace") {
  for (const unsigned threads : thread_counts) {
    for (const std::size_t count : {0u, 1u, 5u, 400u}) {
      CAPTURE(threads);
      CAPTURE(count);
      std::vector<std::size_t> joined;
      std::vector<std::atomic<int>> finished(count);
      std::atomic<int> in_join = 0, strangers = 0;
      Threads some(threads);
      in_order<Workspace>(
          some, count,
          [&](std::size_t i, Workspace& workspace) {
            strangers += workspace.in_use.exchange(true);
            workspace.numbers.assign(3, slow_square(i));
          },
          [&](std::size_t i, Workspace& workspace) {
            strangers += in_join.fetch_add(1) != 0;
            strangers += workspace.numbers != std::vector<std::size_t>(3, i * i);
            joined.push_back(i);
            --in_join;
          },
          [&](std::size_t i, Workspace& workspace) {
            strangers += workspace.numbers != std::vector<std::size_t>(3, i * i);
            workspace.in_use = false;
            ++finished[i];
          });
      CHECK(strangers == 0);
      REQUIRE(joined.size() == count);
      for (std::size_t i = 0; i < count; ++i) {
        CHECK(joined[i] == i);
        CHECK(finished[i] == 1);
      }
    }
  }
}

TEST_CASE("an exception of a step reaches the caller") {
  const auto nothing = [](std::size_t, int&) {};
  const auto bad = [](std::size_t i, int&) {
    if (i == 17) throw std::runtime_error("seventeen");
  };
  for (const unsigned threads : thread_counts) {
    CAPTURE(threads);
    Threads some(threads);
    CHECK_THROWS_WITH(in_order<int>(some, 100, bad, nothing, nothing), "seventeen");
    CHECK_THROWS_WITH(in_order<int>(some, 100, nothing, bad, nothing), "seventeen");
    CHECK_THROWS_WITH(in_order<int>(some, 100, nothing, nothing, bad), "seventeen");
    CHECK_THROWS_WITH(for_each_index(some, 100,
                                     [](std::size_t i) {
                                       if (i == 17) throw std::runtime_error("seventeen");
                                     }),
                      "seventeen");
  }
}

TEST_CASE("parts cover the range, and do not overlap") {
  for (const unsigned threads : thread_counts) {
    for (const std::size_t size : {0u, 1u, 6u, 7u, 8u, 1000u}) {
      CAPTURE(threads);
      CAPTURE(size);
      std::vector<std::atomic<int>> visits(size);
      std::atomic<bool> too_long = false;
      Threads some(threads);
      for_each_part(some, size, 7, [&](std::size_t first, std::size_t last) {
        if (last - first > 7) too_long = true;
        for (std::size_t i = first; i < last; ++i) ++visits[i];
      });
      CHECK_FALSE(too_long);
      for (const auto& v : visits) CHECK(v == 1);
    }
  }
}

TEST_SUITE_END();
