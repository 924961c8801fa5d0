// What: prints contests and targets as Markdown tables on standard output.
#pragma once

#include <string>
#include <vector>

#include "bench/measure.h"
#include "bench/targets.h"

namespace rbpa_bench {

/// Prints the machine, the build and the number of runs.
void print_machine(int runs);

/// Print a table of times: the head, and each row when it is measured.
void print_time_head(const std::vector<Contestant>& contestants);
void print_time_row(const Contest& contest);

/// Prints, below the tables, memory, and the clock of each other program.
void print_memory(const std::vector<Contest>& contests);
void print_clocks(const std::vector<Contest>& contests);

void print(const std::vector<Target>& targets);

}  // namespace rbpa_bench
