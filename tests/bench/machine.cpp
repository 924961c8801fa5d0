#include "bench/machine.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <fstream>

namespace rbpa_bench {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  std::string model = "unknown";
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  return model + ", " + std::to_string(sysconf(_SC_NPROCESSORS_ONLN)) + " cores";
}

std::string memory() {
  const double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  char text[32];
  std::snprintf(text, sizeof text, "%.0f GiB", bytes / 0x1p30);
  return text;
}

std::string system() {
  utsname name{};
  if (uname(&name) != 0) return "unknown";
  return std::string(name.sysname) + " " + name.machine;
}

std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string compiler_flags() { return RBPA_BENCH_FLAGS; }

std::string today() {
  const std::chrono::year_month_day day(std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  char date[16];
  std::snprintf(date, sizeof date, "%d-%02u-%02u", int(day.year()), unsigned(day.month()), unsigned(day.day()));
  return date;
}

std::string machine_and_build() {
  return processor() + "; " + memory() + "; " + system() + "; " + compiler() + " `" + compiler_flags() + "`";
}

}  // namespace rbpa_bench
