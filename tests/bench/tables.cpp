#include "bench/tables.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <ctime>
#include <fstream>

namespace rbpa_bench {

std::string text(const char* format, ...) {
  std::va_list values, again;
  va_start(values, format);
  va_copy(again, values);
  std::string result(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, values)), '\0');
  std::vsnprintf(result.data(), result.size() + 1, format, again);
  va_end(again);
  va_end(values);
  return result;
}

std::string machine() {
  std::ifstream info("/proc/cpuinfo");
  std::string model = "unknown";
  for (std::string line; model == "unknown" && std::getline(info, line);)
    if (line.starts_with("model name")) model = line.substr(line.find(':') + 2);
  const double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  utsname kernel{};
  uname(&kernel);
  const std::time_t now = std::time(nullptr);
  char date[16];
  std::strftime(date, sizeof date, "%F", std::gmtime(&now));
#ifdef __clang__
  constexpr const char* compiler = "clang " __clang_version__;
#else
  constexpr const char* compiler = "g++ " __VERSION__;
#endif
  return text("%s; %s, %ld cores; %.0f GiB; %s %s; %s %s", date, model.c_str(), sysconf(_SC_NPROCESSORS_ONLN),
              bytes / 0x1p30, kernel.sysname, kernel.machine, compiler, RBPA_BENCH_FLAGS);
}

void print_head(const std::vector<std::string>& words, const std::vector<std::string>& numbers) {
  std::vector<std::string> names = words;
  names.insert(names.end(), numbers.begin(), numbers.end());
  print_row(names);
  for (std::size_t i = 0; i < names.size(); ++i) std::printf(i < words.size() ? "|---" : "|--:");
  std::printf("|\n");
}

void print_row(const std::vector<std::string>& cells) {
  for (std::string cell : cells) {
    std::replace(cell.begin(), cell.end(), '|', '/');  // it would end the cell
    std::printf("| %s ", cell.c_str());
  }
  std::printf("|\n");
  std::fflush(stdout);
}

void print_times(const Contest& contest) {
  std::vector<std::string> cells = {contest.set, text("%zu", contest.points), contest.alpha,
                                    text("%zu", contest.outcomes[0].count)};
  std::size_t most = 0;
  for (const Outcome& outcome : contest.outcomes) most = std::max(most, outcome.seconds.of.size());
  for (const Outcome& outcome : contest.outcomes) {
    std::string cell = "**failed**: " + outcome.failure;
    if (outcome.failure.empty()) {
      cell = outcome.wrong.empty() ? "" : "**wrong**: " + outcome.wrong + "; ";
      cell += outcome.seconds.text(0, 1e9 / static_cast<double>(contest.points));
      if (const std::size_t runs = outcome.seconds.of.size(); runs < most) cell += text(" in %zu", runs);
      if (&outcome != contest.outcomes.data() && outcome.is_good())
        cell += text("; %.3g×", contest.ratio(outcome.name, contest.outcomes[0].name));
    }
    cells.push_back(cell);
  }
  print_row(cells);
}

void print_bytes(const std::vector<Contest>& contests) {
  std::printf("\nBytes a point: peak of resident memory beyond the input, in a process of its own.\n\n");
  print_head({"points"}, columns({"number", "α"}, contests[0].outcomes));
  for (const Contest& contest : contests) {
    std::vector<std::string> cells = {contest.set, text("%zu", contest.points), contest.alpha};
    for (const Outcome& outcome : contest.outcomes)
      cells.push_back(std::isnan(outcome.bytes) ? "?"
                                                : text("%.0f", outcome.bytes / static_cast<double>(contest.points)));
    print_row(cells);
  }
}

}  // namespace rbpa_bench
