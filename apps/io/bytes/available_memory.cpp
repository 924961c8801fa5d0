#include "io/bytes/available_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>

namespace rbpa::app {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Returns the first number in a file of the system; nothing if there is no such file, or if the file begins with a
/// word, such as "max".
std::optional<double> first_number(const std::string& path) {
  std::ifstream file(path);
  double number = 0;
  if (file >> number) return number;
  return std::nullopt;
}

double of_machine() {
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);) {
    double kibibytes = 0;
    if (std::sscanf(line.c_str(), "MemAvailable: %lf kB", &kibibytes) == 1) return 1024 * kibibytes;
  }
  return unlimited;
}

/// Returns the bytes that a control group, of either version, leaves to its processes: the number in the file `most` of
/// its folder less the number in `used`; infinity if there is no limit.
double left_by(const std::string& folder, const char* most, const char* used) {
  const std::optional<double> limit = first_number(folder + most), in_use = first_number(folder + used);
  return limit ? std::max(*limit - in_use.value_or(0), 0.0) : unlimited;
}

/// Returns the least number of bytes that the control group of this process, or a group around it, leaves. Within a
/// container the group of the process is mounted as the root.
double of_groups() {
  double least = unlimited;
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool is_unified = controllers.empty();
    if (!is_unified && controllers.find("memory") == std::string::npos) continue;
    for (std::string group = line.substr(second + 1);;) {
      const std::string folder = (is_unified ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory") + group + "/";
      least = std::min(least, is_unified ? left_by(folder, "memory.max", "memory.current")
                                         : left_by(folder, "memory.limit_in_bytes", "memory.usage_in_bytes"));
      const std::size_t slash = group.rfind('/');
      if (group.empty() || slash == std::string::npos) break;
      group.resize(slash);
    }
  }
  return least;
}

double of_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  const double used = first_number("/proc/self/statm").value_or(0) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::max(static_cast<double>(limit.rlim_cur) - used, 0.0);
}

}  // namespace

std::optional<double> available_memory() {
  const double least = std::min({of_machine(), of_groups(), of_address_space()});
  return least < unlimited ? std::optional(least) : std::nullopt;
}

std::string bytes_text(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, bytes >= 1e9 ? "%.1f GB" : "%.0f MB", bytes >= 1e9 ? bytes / 1e9 : bytes / 1e6);
  return text;
}

}  // namespace rbpa::app
