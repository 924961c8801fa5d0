// Random calls of all members of a front.
#include <doctest/doctest.h>

#include "walk/front_policies.h"
#include "walk/front_walk.h"

using namespace meshops::test;

namespace {

void walk(std::uint64_t seed, std::size_t steps) {
  RandomChoices choices(seed);
  FrontWalkCounts counts;
  CHECK_NOTHROW(walk_on_front(choices, steps, counts));
  CHECK(counts.attached > counts.steps / 40);
  CHECK(counts.created > counts.steps / 100);
  CHECK(counts.detached > counts.steps / 100);
  CHECK(counts.levels > counts.steps / 100);
  CHECK(counts.begun_on_mesh > counts.steps / 1000);
  CHECK(counts.joined_fans > counts.steps / 1000);
  CHECK(counts.pinches > counts.steps / 100);
  for (const std::size_t refused : counts.refused) CHECK(refused > 20);
}

void advance(std::uint64_t seed, std::size_t questions) {
  RandomChoices choices(seed);
  AdvanceCounts counts;
  CHECK_NOTHROW(advance_at_random(choices, questions, counts));
  CHECK(counts.attached > counts.proposals / 20);
  CHECK(counts.refused > counts.proposals / 20);
  CHECK(counts.detached > counts.proposals / 200);
  CHECK(counts.seeded > counts.proposals / 1000);
  CHECK(counts.seeds_refused > counts.proposals / 1000);
  CHECK(counts.deferred > counts.proposals / 20);
  CHECK(counts.lists > counts.proposals / 20);
  CHECK(counts.policies > 200);
  CHECK(counts.thrown > counts.proposals / 500);
  CHECK(counts.glued > counts.proposals / 100);
  CHECK(counts.not_glued > counts.proposals / 100);
  CHECK(counts.there > counts.proposals / 10'000);
}

}  // namespace

TEST_SUITE("front walk") {
  TEST_CASE("a front does what its model does, refuses what the model refuses, and changes nothing when it refuses") {
    walk(1, 100'000);
  }
  TEST_CASE("an advancing front stays sound for any answers of a policy, in any order, and when the policy throws") {
    advance(2, 100'000);
  }
}

// Only the nightly tests run this suite: it takes too long for every run.
TEST_SUITE("long walk" * doctest::skip()) {
  TEST_CASE("1,000,000 random calls of fronts agree with the model") { walk(3, 1'000'000); }
  TEST_CASE("1,000,000 random proposals leave advancing fronts sound") { advance(4, 1'000'000); }
}
