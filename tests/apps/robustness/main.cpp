// Whatever happens to a program at whatever moment, what was in its outputs before is intact, or what it makes is whole
// in its place; and nothing else is left in the folder.
//   test_robustness [--moments=N]      2 moments for each verb and each thing that happens
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdlib>
#include <string_view>

#include "robustness/moments.h"

namespace robustness {
int moments = 2;
}  // namespace robustness

int main(int argc, char** argv) {
  constexpr std::string_view option = "--moments=";
  for (int i = 1; i < argc; ++i)
    if (std::string_view(argv[i]).starts_with(option)) robustness::moments = std::atoi(argv[i] + option.size());
  return doctest::Context(argc, argv).run();
}
