// What: reads numbers given to a test executable as --name=value, in addition to doctest's own options.
#pragma once

#include <cstdint>
#include <string_view>

namespace rbpa_test {

/// Returns the value of the last --name=value, or `fallback`.
std::uint64_t argument(std::string_view name, std::uint64_t fallback);

/// Returns whether --all-trials=1 is given, as in nightly runs; otherwise the long loops over random inputs are
/// shorter.
bool all_trials();

/// Returns the number of random inputs that a test tries: all of them in nightly runs, otherwise a quarter.
int trials(int all);

}  // namespace rbpa_test
