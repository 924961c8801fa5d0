// A random walk over all operators: see judge.h for the law.
#include <doctest/doctest.h>

#include "support/arguments.h"
#include "walk/walk.h"
#include "walk/wrong_calls.h"

using namespace meshops::test;

namespace {

std::map<std::string, Judge::Tally> walk(Walk::On on, std::uint64_t first_seed, int steps) {
  std::map<std::string, Judge::Tally> sum;
  constexpr int steps_on_a_mesh = 250;
  for (int done = 0; done < steps; done += steps_on_a_mesh) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(done);
    RandomChoices random(seed);
    Walk walk(random, on);
    for (int step = 0; step < steps_on_a_mesh; ++step) {
      try {
        walk.step();
      } catch (const WalkFailure& failure) {
        FAIL("seed " << seed << ", step " << step << ": " << std::string(failure.what()));
      }
    }
    for (const auto& [name, tally] : walk.tally()) {
      sum[name].done += tally.done;
      sum[name].refused += tally.refused;
    }
  }
  return sum;
}

void check_tally(const std::map<std::string, Judge::Tally>& sum, int least) {
  for (const auto& named : sum) {
    const auto& name = named.first;
    const Judge::Tally& tally = named.second;
    INFO(name, ": ", tally.done, " done, ", tally.refused, " refused");
    CHECK(tally.done >= least);
    CHECK((tally.refused >= least || name == "create_triangle"));
  }
  CHECK(sum.size() == 22);
}

}  // namespace

TEST_SUITE("walk") {
  TEST_CASE("random steps on manifolds agree with the model if done, and would have been bad if refused") {
    check_tally(walk(Walk::On::manifolds, 1, rbpa_test::trials(100000)), rbpa_test::trials(200));
  }

  TEST_CASE("random steps on meshes with bowties do not crash, and add no defects") {
    check_tally(walk(Walk::On::bowties, 1, rbpa_test::trials(50000)), rbpa_test::trials(50));
  }

  TEST_CASE(
      "calls with wrong arguments, effects and callables are done or refused, and a refused call changes no bit") {
    std::map<std::string, Judge::Tally> sum;
    const int meshes = rbpa_test::trials(150);
    for (int seed = 1; seed <= meshes; ++seed) {
      CAPTURE(seed);
      RandomChoices random(static_cast<std::uint64_t>(seed));
      try {
        for (const auto& [name, tally] : call_wrongly(random, 250)) {
          sum[name].done += tally.done;
          sum[name].refused += tally.refused;
        }
      } catch (const WalkFailure& failure) {
        FAIL(failure.what());
      }
    }
    CHECK(sum.size() == 57);
    for (const auto& [name, tally] : sum) {
      const std::string counts = name + ": " + std::to_string(tally.done) + " done, " + std::to_string(tally.refused);
      INFO(counts, " refused");
      const bool is_never_done = name.find("again") != std::string::npos ||
                                 name.find("hook that throws") != std::string::npos ||
                                 name.find("of another mesh") != std::string::npos || name == "build_mesh";
      if (name != "insert_diagonal") CHECK((tally.done > 0) == !is_never_done);  // few meshes have a face to cut
      CHECK((tally.refused > 0 || name == "create_triangle" || name == "cut_open and glue_back"));
    }
  }
}

// Too long for every run: only the nightly tests run it.
TEST_SUITE("long walk" * doctest::skip()) {
  TEST_CASE("3,000,000 random steps on manifolds agree with the model") {
    check_tally(walk(Walk::On::manifolds, 1000000, 3000000), 6000);
  }
  TEST_CASE("1,000,000 random steps on meshes with bowties add no defects") {
    check_tally(walk(Walk::On::bowties, 1000000, 1000000), 1000);
  }
}
