// Fronts: for any calls and any answers of a policy, chosen by the bytes of a fuzzer (tests/meshops/walk), a front does
//         what its model does, refuses what the model refuses, and stays sound.
#include <stdexcept>

#include "fuzz/target.h"
#include "walk/front_policies.h"
#include "walk/front_walk.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meshops::test;
  ByteChoices choices({data, size});
  constexpr std::size_t steps = 300;
  try {
    if (choices.one_in(2)) {
      FrontWalkCounts counts;
      walk_on_front(choices, steps, counts);
    } else {
      AdvanceCounts counts;
      advance_at_random(choices, steps, counts);
    }
  } catch (const LawBroken& broken) {
    fuzz::require(false, broken.what());
  }
  return 0;
}
