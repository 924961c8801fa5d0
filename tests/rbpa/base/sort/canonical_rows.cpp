// Rows in lexicographic order, compared with std::sort.
#include "rbpa/base/sort/canonical_rows.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "support/random.h"

using rbpa::Row;
using namespace rbpa_test;

TEST_SUITE_BEGIN("parallel");

TEST_CASE("rows are sorted, and each is at the reported place, with any number of threads") {
  Random random(3195);
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t bound = 1 + random.below(trial % 3 == 0 ? 3 : 30'000), wanted = random.below(3000);
    std::set<Row> distinct;
    for (std::size_t i = 0; i < wanted; ++i)
      distinct.insert({static_cast<std::uint32_t>(random.below(bound)), static_cast<std::uint32_t>(random.below(40)),
                       static_cast<std::uint32_t>(random.below(1u << 31)),
                       static_cast<std::uint32_t>(random.below(9))});
    std::vector<Row> rows(distinct.begin(), distinct.end()), sorted = {{1, 2, 3, 4}};
    random.shuffle(rows);
    rbpa::Threads threads(static_cast<unsigned>(1 + trial % 2));
    const auto place = rbpa::sort_rows(rows, bound, threads, sorted);
    CHECK(sorted == std::vector<Row>(distinct.begin(), distinct.end()));
    REQUIRE(place.size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) CHECK(sorted[place[i]] == rows[i]);
  }
}

TEST_SUITE_END();
