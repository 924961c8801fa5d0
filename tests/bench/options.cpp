#include "bench/options.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace rbpa_bench {
namespace {

template <typename Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() && number > 0;
}

/// Parses the value of an option. Returns: false when it is none.
struct Value {
  std::string_view text;

  bool operator()(bool* into) const { return *into = text.empty(); }
  bool operator()(int* into) const { return read_number(text, *into); }
  bool operator()(double* into) const { return read_number(text, *into); }
  bool operator()(std::string* into) const { return !(*into = text).empty(); }
  bool operator()(std::vector<std::string>* into) const { return !into->emplace_back(text).empty(); }
  bool operator()(std::size_t* into) const {
    constexpr std::string_view units = "KMG";
    const std::size_t unit = text.empty() ? units.npos : units.find(text.back());
    std::size_t times = 1;
    for (std::size_t i = 0; unit != units.npos && i <= unit; ++i) times *= 1000;
    if (!read_number(text.substr(0, text.size() - (times > 1)), *into) || *into > 1'000'000'000'000 / times)
      return false;
    *into *= times;
    return true;
  }
  /// Reads a list such as "1,2".
  bool operator()(std::vector<unsigned>* into) const {
    into->clear();
    for (std::string_view rest = text;; rest.remove_prefix(1)) {
      const std::size_t comma = std::min(rest.find(','), rest.size());
      if (!read_number(rest.substr(0, comma), into->emplace_back())) return false;
      rest.remove_prefix(comma);
      if (rest.empty()) return true;
    }
  }
};

[[noreturn]] void end_with_usage(std::FILE* to, const char* program, const std::vector<Option>& options, int code) {
  std::fprintf(to, "usage: %s [OPTIONS]\n", program);
  for (const Option& option : options) std::fprintf(to, "  %-20s  %s\n", option.name.c_str(), option.help.c_str());
  std::exit(code);
}

}  // namespace

void read_options(int argc, char** argv, const std::vector<Option>& options) {
  std::size_t words = 0, words_needed = 0;
  for (const Option& option : options) words_needed += !option.name.starts_with("--");
  for (int i = 1; i < argc; ++i) {
    const std::string given = argv[i];
    if (given == "--help") end_with_usage(stdout, argv[0], options, 0);
    const std::size_t sign = given.starts_with("--") ? std::min(given.find('='), given.size()) : 0;
    const bool is_read = std::any_of(options.begin(), options.end(), [&](const Option& option) {
      if (sign == 0)
        return !option.name.starts_with("--") && ++words <= words_needed && std::visit(Value{given}, option.into);
      if (option.name != given.substr(0, sign)) return false;
      if (sign < given.size())
        return sign + 1 < given.size() && std::visit(Value{std::string_view(given).substr(sign + 1)}, option.into);
      if (std::holds_alternative<bool*>(option.into)) return std::visit(Value{}, option.into);
      return i + 1 < argc && std::visit(Value{argv[++i]}, option.into);
    });
    if (is_read) continue;
    std::fprintf(stderr, "%s: found '%s'\n", argv[0], given.c_str());
    end_with_usage(stderr, argv[0], options, 2);
  }
  if (words < words_needed) end_with_usage(stderr, argv[0], options, 2);
}

Sizes read_sizes(int argc, char** argv, Sizes sizes, std::vector<Option> others) {
  others.insert(others.begin(), {{"--points", &sizes.points, "number of points, " + std::to_string(sizes.points)},
                                 {"--runs", &sizes.runs, "runs of each, in turn, " + std::to_string(sizes.runs)}});
  read_options(argc, argv, others);
  return sizes;
}

}  // namespace rbpa_bench
