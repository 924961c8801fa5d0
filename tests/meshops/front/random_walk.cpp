// Everything that a front can be asked, at random: RBPA_LONG_WALKS makes the walks long.
#include <doctest/doctest.h>

#include <cstdlib>

#include "support/front_walk.h"

using namespace meshops::test;

namespace {
std::size_t times(std::size_t usual, std::size_t many) {
  return std::getenv("RBPA_LONG_WALKS") != nullptr ? many : usual;  // NOLINT(concurrency-mt-unsafe)
}
}  // namespace

TEST_SUITE("front walk") {
  TEST_CASE("a front does what its model does, refuses what the model refuses, and changes nothing when it refuses") {
    RandomChoices choices(1);
    FrontWalkCounts counts;
    CHECK_NOTHROW(walk_on_front(choices, times(100'000, 1'000'000), counts));
    CHECK(counts.attached > counts.steps / 40);
    CHECK(counts.created > counts.steps / 100);
    CHECK(counts.detached > counts.steps / 100);
    CHECK(counts.levels > counts.steps / 100);
    CHECK(counts.begun_on_mesh > counts.steps / 1000);
    CHECK(counts.joined_fans > counts.steps / 1000);
    CHECK(counts.pinches > counts.steps / 100);
    for (const std::size_t refused : counts.refused) CHECK(refused > 20);
  }

  TEST_CASE("an advancing front is sound whatever a policy answers, in any order, and when it throws") {
    RandomChoices choices(2);
    AdvanceCounts counts;
    CHECK_NOTHROW(advance_at_random(choices, times(100'000, 1'000'000), counts));
    CHECK(counts.attached > counts.proposals / 20);
    CHECK(counts.refused > counts.proposals / 20);
    CHECK(counts.detached > counts.proposals / 200);
    CHECK(counts.seeded > counts.proposals / 1000);
    CHECK(counts.seeds_refused > counts.proposals / 1000);
    CHECK(counts.thrown > counts.proposals / 2000);
  }
}
