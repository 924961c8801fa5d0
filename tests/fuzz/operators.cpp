// Fuzz target: a walk over all operators of libmeshops (tests/meshops/walk), with the bytes for its choices.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "walk/walk.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meshops::test;
  ByteChoices choices({data, size});
  const Walk::On on = choices.one_in(2) ? Walk::On::bowties : Walk::On::manifolds;
  Walk walk(choices, on);
  try {
    for (int step = 0; step < 300 && choices.any_left(); ++step) walk.step();
  } catch (const WalkFailure& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    std::abort();
  }
  return 0;
}
