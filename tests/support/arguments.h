// What: numbers given to a test executable as --name=value, beside doctest's own options.
#pragma once

#include <cstdint>
#include <string_view>

namespace rbpa_test {

/// The value of the last --name=value, or `fallback`.
std::uint64_t argument(std::string_view name, std::uint64_t fallback);

/// Whether --all-trials=1 is given, as at night: by day the long loops over random inputs are shorter.
bool all_trials();

/// How many of `all` random inputs a test tries: all of them at night, a quarter by day.
int trials(int all);

}  // namespace rbpa_test
