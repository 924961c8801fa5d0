// The number of threads that work.
#include <doctest/doctest.h>

#include <limits>
#include <set>
#include <thread>

#include "rbpa/hrbpa.h"
#include "rbpa/rbpa.h"
#include "support/generate.h"

using namespace rbpa_test;
using rbpa::threads_used;

TEST_SUITE_BEGIN("parallel");

TEST_CASE("as many threads work as given, but at most one for each processor; for 0, one for each") {
  const unsigned processors = threads_used(1'000'000, 0);
  REQUIRE(processors >= 1);
  for (unsigned wanted = 1; wanted <= processors; ++wanted) CHECK(threads_used(1'000'000, wanted) == wanted);
  for (const unsigned wanted : {processors + 1, std::numeric_limits<unsigned>::max()})
    CHECK(threads_used(1'000'000, wanted) == processors);
}

TEST_CASE("one thread works on few points") {
  for (const unsigned wanted : {0u, 1u, 2u, 1024u}) CHECK(threads_used(100, wanted) == 1);
}

TEST_CASE("a run reports its progress from no more threads than threads_used returns") {
  const Points points = uniform(50'000, 4);
  for (const unsigned wanted : {0u, 1u, 2u}) {
    std::set<std::thread::id> tellers;
    const auto progress = [&](const rbpa::Progress&) {
      tellers.insert(std::this_thread::get_id());
      return true;
    };
    rbpa::rbpa(points, 1, {.threads = wanted, .progress = progress});
    CHECK(!tellers.empty());
    CHECK(tellers.size() <= threads_used(points.size(), wanted));
    tellers.clear();
    rbpa::hrbpa(points, 1, {.threads = wanted, .progress = progress});
    CHECK(!tellers.empty());
    CHECK(tellers.size() <= threads_used(points.size(), wanted));
  }
}

TEST_SUITE_END();
