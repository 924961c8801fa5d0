// What: reads the command line of every benchmark, and prints its usage for --help and for what is wrong.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace rbpa_bench {

/// Option `--name=VALUE` or `--name VALUE`, or `--name` alone for a bool. A name without dashes is that of a word that
/// must be given, such as a folder. Numbers are above 0; counts of points may end in K, M or G.
struct Option {
  std::string name;
  std::variant<bool*, int*, std::size_t*, double*, std::string*, std::vector<unsigned>*, std::vector<std::string>*>
      into;
  std::string help;
};

/// Reads the command line. Ends the program with the usage, with code 0 for --help, and 2 for anything unknown.
void read_options(int argc, char** argv, const std::vector<Option>& options);

/// Options of most programs, and their defaults.
struct Sizes {
  std::size_t points = 1000000;
  int runs = 5;
};

/// Reads `--points` and `--runs`, and others.
Sizes read_sizes(int argc, char** argv, Sizes defaults = {}, std::vector<Option> others = {});

}  // namespace rbpa_bench
