// Operators: a walk over all of them, with right and wrong calls (tests/meshops/walk), chosen by the bytes of a fuzzer.
#include "fuzz/target.h"
#include "walk/walk.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meshops::test;
  ByteChoices choices({data, size});
  const Walk::On on = choices.one_in(2) ? Walk::On::bowties : Walk::On::manifolds;
  Walk walk(choices, on);
  try {
    for (int step = 0; step < 300 && choices.any_left(); ++step) walk.step();
  } catch (const WalkFailure& failure) {
    fuzz::require(false, failure.what());
  }
  return 0;
}
