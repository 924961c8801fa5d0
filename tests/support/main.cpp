#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <charconv>
#include <string_view>
#include <vector>

#include "support/arguments.h"

namespace rbpa_test {
namespace {

std::vector<std::string_view>& arguments() {
  static std::vector<std::string_view> given;
  return given;
}

}  // namespace

std::uint64_t argument(std::string_view name, std::uint64_t fallback) {
  std::uint64_t value = fallback;
  for (std::string_view given : arguments()) {
    if (!given.starts_with("--")) continue;
    given.remove_prefix(2);
    if (!given.starts_with(name) || given.substr(name.size(), 1) != "=") continue;
    given.remove_prefix(name.size() + 1);
    std::from_chars(given.data(), given.data() + given.size(), value);
  }
  return value;
}

bool all_trials() { return argument("all-trials", 0) != 0; }

int trials(int all) { return all_trials() ? all : (all + 3) / 4; }

}  // namespace rbpa_test

int main(int argc, char** argv) {
  rbpa_test::arguments().assign(argv + 1, argv + argc);
  return doctest::Context(argc, argv).run();
}
