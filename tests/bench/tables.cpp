#include "bench/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/machine.h"

namespace rbpa_bench {
namespace {

/// Returns text that does not end a cell.
std::string in_cell(std::string text) {
  std::replace(text.begin(), text.end(), '|', '/');
  return text;
}

std::string rounded(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/// Returns a value with three digits.
std::string significant(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

Timings nanoseconds_a_point(const Contest& contest, const Outcome& outcome) {
  Timings all = outcome.seconds;
  for (double& seconds : all.of) seconds *= 1e9 / static_cast<double>(contest.points);
  return all;
}

std::string time_cell(const Contest& contest, const Outcome& outcome) {
  if (!outcome.failure.empty()) return "**failed**: " + in_cell(outcome.failure);
  std::string time = nanoseconds_a_point(contest, outcome).text();
  std::size_t most = 0;
  for (const Outcome& other : contest.outcomes) most = std::max(most, other.seconds.of.size());
  if (const std::size_t runs = outcome.seconds.of.size(); runs < most) time += " in " + std::to_string(runs);
  if (!outcome.wrong.empty()) return "**wrong**: " + outcome.wrong + "; " + time;
  const std::optional<double> ratio = speedup(contest, contest.outcomes[0].contestant, outcome.contestant);
  return &outcome == &contest.outcomes[0] || !ratio ? time : time + "; " + significant(*ratio) + "×";
}

void print_head(const std::vector<std::string>& text, const std::vector<std::string>& numbers) {
  for (const std::string& column : text) std::printf("| %s ", column.c_str());
  for (const std::string& column : numbers) std::printf("| %s ", in_cell(column).c_str());
  std::printf("|\n");
  for (std::size_t i = 0; i < text.size(); ++i) std::printf("|---");
  for (std::size_t i = 0; i < numbers.size(); ++i) std::printf("|--:");
  std::printf("|\n");
}

}  // namespace

void print_machine(int runs) {
  std::printf("%s; %d runs of each in turn after one that does not count; memory stays with the process.\n\n",
              machine_and_build().c_str(), runs);
}

void print_time_head(const std::vector<Contestant>& contestants) {
  std::vector<std::string> numbers{"number", "α", "triangles"};
  for (const Contestant& contestant : contestants) numbers.push_back(contestant.name);
  print_head({"points"}, numbers);
}

void print_time_row(const Contest& contest) {
  std::printf("| %s | %zu | %s | %zu |", contest.set.c_str(), contest.points, contest.alpha_text.c_str(),
              contest.outcomes[0].triangles);
  for (const Outcome& outcome : contest.outcomes) std::printf(" %s |", time_cell(contest, outcome).c_str());
  std::printf("\n");
  std::fflush(stdout);
}

void print_memory(const std::vector<Contest>& contests) {
  if (contests.empty()) return;
  std::vector<std::string> numbers{"number", "α"};
  for (const Outcome& outcome : contests[0].outcomes) numbers.push_back(outcome.contestant);
  print_head({"points"}, numbers);
  for (const Contest& contest : contests) {
    std::printf("| %s | %zu | %s |", contest.set.c_str(), contest.points, contest.alpha_text.c_str());
    for (const Outcome& outcome : contest.outcomes)
      std::printf(" %s |", outcome.bytes && outcome.failure.empty()
                               ? rounded(*outcome.bytes / static_cast<double>(contest.points), 0).c_str()
                               : "?");
    std::printf("\n");
  }
  std::printf("\n");
}

void print_clocks(const std::vector<Contest>& contests) {
  if (contests.empty()) return;
  for (const Outcome& outcome : contests[0].outcomes)
    if (outcome.clock != Clock::here)
      std::printf("%s: another program; time %s, memory of its whole process.\n\n", outcome.contestant.c_str(),
                  outcome.clock == Clock::peer ? "as it says itself" : "of its whole process, files included");
}

void print(const std::vector<Target>& targets) {
  print_head({"target"}, {"measured", ""});
  for (const Target& target : targets) {
    const std::string measured = target.measured ? significant(*target.measured) : "–";
    std::printf("| %s %s %s | %s | %s |\n", target.what.c_str(), target.sense == Sense::at_least ? "≥" : "≤",
                significant(target.bound).c_str(), measured.c_str(),
                !target.measured ? "not measured" : (is_met(target) ? "met" : "**missed**"));
  }
  std::printf("\n");
}

}  // namespace rbpa_bench
