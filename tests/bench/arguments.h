// What: reads the arguments of the programs that print tables.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace rbpa_bench {

struct Arguments {
  std::size_t points = 1000000;
  int runs = 5;
  std::vector<unsigned> threads{1, 2};
  double alpha = std::numeric_limits<double>::infinity();  // in mean spacings
};

/// The options that a program takes besides the numbers of points and of runs.
struct Takes {
  bool threads = false, alpha = false;
};

/// Parses all of `text` as a number. Returns: false when it is none.
template <typename Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

/// Parses a list such as "1,2". Returns: false when it is not numbers with commas between them.
inline bool read_threads(std::string_view list, std::vector<unsigned>& threads) {
  threads.clear();
  for (bool more = true; more;) {
    const std::size_t comma = std::min(list.find(','), list.size());
    more = comma < list.size();
    if (!read_number(list.substr(0, comma), threads.emplace_back())) return false;
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return true;
}

/// Returns the rest of an argument that begins with `name`.
inline std::optional<std::string_view> behind(std::string_view given, std::string_view name) {
  if (!given.starts_with(name)) return std::nullopt;
  return given.substr(name.size());
}

/// Parses `[--runs=N] [--points=N]`, and `[--threads=1,2]` and `[--alpha=SPACINGS]` for programs that have them;
/// missing values are those of `arguments`. Returns: nothing, after printing the usage on standard error, when there is
/// anything else.
inline std::optional<Arguments> parse(int argc, char** argv, Takes takes = {}, Arguments arguments = {}) {
  for (const std::string_view given : std::vector<std::string_view>(argv + 1, argv + argc)) {
    const auto number = [&](std::string_view name, auto& into) {
      const auto text = behind(given, name);
      return text && read_number(*text, into) && into > 0;
    };
    if (number("--points=", arguments.points) || number("--runs=", arguments.runs)) continue;
    if (takes.alpha && number("--alpha=", arguments.alpha)) continue;
    if (const auto list = behind(given, "--threads="); takes.threads && list && read_threads(*list, arguments.threads))
      continue;
    std::fprintf(stderr, "usage: %s [--runs=N] [--points=N]%s%s\n", argv[0], takes.threads ? " [--threads=1,2]" : "",
                 takes.alpha ? " [--alpha=SPACINGS]" : "");
    return std::nullopt;
  }
  return arguments;
}

}  // namespace rbpa_bench
