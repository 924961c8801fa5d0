// What: numbers given to a test executable as --name=value, beside doctest's own options.
#pragma once

#include <cstdint>
#include <string_view>

namespace rbpa_test {

/// The value of the last --name=value, or `fallback`.
std::uint64_t argument(std::string_view name, std::uint64_t fallback);

}  // namespace rbpa_test
