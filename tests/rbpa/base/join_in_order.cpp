// Parallel work of programs: results joined in order, and items made ahead.
#include "rbpa/base/join_in_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "rbpa/base/read_ahead.h"

using rbpa::join_in_order;
using rbpa::ReadAhead;

TEST_SUITE_BEGIN("parallel");

namespace {

/// Takes a different time for each i, so that items overtake each other.
std::size_t slow(std::size_t i) {
  std::atomic<std::size_t> sum = 0;
  for (std::size_t k = 0; k < (i * 7919 % 13) * 1000; ++k) sum += k;
  return i;
}

}  // namespace

TEST_CASE("results are joined once, in order, one at a time, and at most as many wait as there are threads") {
  for (const std::size_t threads : {1U, 2U, 5U})
    for (const std::size_t count : {0U, 1U, 7U, 300U})
      for (const bool is_small : {false, true}) {
        CAPTURE(threads);
        CAPTURE(count);
        std::vector<std::size_t> joined;
        std::atomic<int> in_join = 0, strangers = 0;
        std::atomic<std::size_t> made = 0, most = 0;
        join_in_order(
            threads, count,
            [&](std::size_t i) {
              const std::size_t result = slow(i);
              ++made;
              return result;
            },
            [&](std::size_t) { return is_small; },
            [&](std::size_t i, std::size_t result) {
              strangers += in_join.fetch_add(1) != 0 || result != i;
              most = std::max<std::size_t>(most, made - joined.size());
              joined.push_back(i);
              --in_join;
            });
        CHECK(strangers == 0);
        REQUIRE(joined.size() == count);
        for (std::size_t i = 0; i < count; ++i) CHECK(joined[i] == i);
        CHECK(most <= (is_small ? 2 * threads + 1 : threads + 1));  // in work, and waiting
      }
}

TEST_CASE("an exception of work or joining reaches the caller") {
  const auto bad = [](std::size_t i) {
    if (i == 17) throw std::runtime_error("seventeen");
    return i;
  };
  const auto is_small = [](std::size_t) { return true; };
  for (const std::size_t threads : {1U, 2U, 5U}) {
    CHECK_THROWS_WITH(join_in_order(threads, 100, bad, is_small, [](std::size_t, std::size_t) {}), "seventeen");
    CHECK_THROWS_WITH(join_in_order(threads, 100, slow, is_small, [&](std::size_t i, std::size_t) { bad(i); }),
                      "seventeen");
  }
}

TEST_CASE("items come in the order in which they are made, then an exception; a consumer may stop early") {
  for (const std::size_t others : {0U, 1U, 4U})
    for (const std::size_t most : {1U, 3U, 9U})
      for (const bool fails_in_work : {false, true}) {
        CAPTURE(others);
        CAPTURE(most);
        CAPTURE(fails_in_work);
        std::atomic<int> in_make = 0, strangers = 0, worked = 0, made = 0;
        const auto fail_at = [](int i, int at) {
          if (i == at) throw std::runtime_error("fifty");
        };
        const auto make = [&](int& item) {
          strangers += in_make.fetch_add(1) != 0 || item != 0;
          if (!fails_in_work) fail_at(made, 50);
          item = static_cast<int>(slow(static_cast<std::size_t>(made)));
          ++made;
          --in_make;
          return made < 80;
        };
        const auto work = [&](int& item) {
          slow(static_cast<std::size_t>(item));
          if (fails_in_work) fail_at(item, 50);
          item *= 2;
          ++worked;
        };
        {
          ReadAhead<int> items(others, most, make, work);
          int item = -1;
          for (int i = 0; i < 50; ++i) {
            REQUIRE(items.next(item));
            CHECK(item == 2 * i);
            if (i % 16 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));  // until the queue is full
            CHECK(made <= i + 1 + static_cast<int>(most));
          }
          for (int i = 0; i < 2; ++i) CHECK_THROWS_WITH(items.next(item), "fifty");
        }
        CHECK(strangers == 0);
        CHECK(worked >= 50);
        made = worked = 0;
        { ReadAhead<int> items(others, most, make, work); }
        CHECK(made <= static_cast<int>(most));
        CHECK(worked == made);
      }
  ReadAhead<int> none(2, 3, [](int&) { return false; });
  int item = 0;
  CHECK_FALSE(none.next(item));
}

TEST_SUITE_END();
