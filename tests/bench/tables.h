// What: prints Markdown tables, and contests, on standard output.
#pragma once

#include <string>
#include <vector>

#include "bench/measure.h"

namespace rbpa_bench {

/// Returns what std::printf() would print.
[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);

/// Returns the date, the machine and the build: "2026-11-22; AMD EPYC, 2 cores; 24 GiB; Linux x86_64; g++ 12.2.0 -O3".
std::string machine();

/// Prints the head of a table: columns of text, then columns of numbers.
void print_head(const std::vector<std::string>& words, const std::vector<std::string>& numbers);
void print_row(const std::vector<std::string>& cells);

/// Returns the names of contestants, behind other columns.
template <typename Named>
std::vector<std::string> columns(std::vector<std::string> before, const std::vector<Named>& contestants) {
  for (const Named& contestant : contestants) before.push_back(contestant.name);
  return before;
}

/// Prints a row: set, number, alpha, size of the result, and the time of each contestant, with how many times as long
/// as the first it took.
void print_times(const Contest& contest);
/// Prints a table of bytes a point.
void print_bytes(const std::vector<Contest>& contests);

}  // namespace rbpa_bench
