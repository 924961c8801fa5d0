// Parallel work of programs: results joined in order, and items made ahead.
#include "rbpa/base/join_in_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
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

TEST_CASE("items come in the order in which they are made, then the maker's exception; a consumer may stop early") {
  int made = 0;
  const auto make = [&](int& item) {
    if (made == 50) throw std::runtime_error("fifty");
    item = made++;
    return true;
  };
  {
    ReadAhead<int> items(3, make);
    int item = -1;
    for (int i = 0; i < 50; ++i) {
      REQUIRE(items.next(item));
      CHECK(item == i);
    }
    CHECK_THROWS_WITH(items.next(item), "fifty");
  }
  made = 0;
  { ReadAhead<int> items(3, make); }
  CHECK(made <= 4);
  ReadAhead<int> none(3, [](int&) { return false; });
  int item = 0;
  CHECK_FALSE(none.next(item));
}

TEST_SUITE_END();
