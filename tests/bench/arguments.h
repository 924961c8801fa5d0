// What: the arguments of the programs that print tables.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace rbpa_bench {

struct Arguments {
  std::size_t points = 1000000;
  int runs = 5;
};

/// `[--runs=N] [--points=N]`; nothing, and the usage on standard error, when there is anything else.
inline std::optional<Arguments> parse(int argc, char** argv) {
  Arguments arguments;
  for (const std::string_view given : std::vector<std::string_view>(argv + 1, argv + argc)) {
    const auto value = [&](std::string_view name, auto& number) {
      if (!given.starts_with(name)) return false;
      const auto [end, error] = std::from_chars(given.data() + name.size(), given.data() + given.size(), number);
      return error == std::errc{} && end == given.data() + given.size() && number > 0;
    };
    if (value("--points=", arguments.points) || value("--runs=", arguments.runs)) continue;
    std::fprintf(stderr, "usage: %s [--runs=N] [--points=N]\n", argv[0]);
    return std::nullopt;
  }
  return arguments;
}

}  // namespace rbpa_bench
