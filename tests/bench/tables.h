// What: contests and targets as Markdown tables on standard output.
#pragma once

#include <string>
#include <vector>

#include "bench/measure.h"
#include "bench/targets.h"

namespace rbpa_bench {

/// The machine, the build and how often each ran.
void print_machine(int runs);

/// A table of times, row by row as they come.
void print_time_head(const std::vector<Contestant>& contestants);
void print_time_row(const Contest& contest);

/// Below the tables: memory, and by whose clocks other programs were timed.
void print_memory(const std::vector<Contest>& contests);
void print_clocks(const std::vector<Contest>& contests);

void print(const std::vector<Target>& targets);

}  // namespace rbpa_bench
