#include "bench/memory.h"

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <string>

namespace rbpa_bench {
namespace {

/// Reads a line "name:  1234 kB" of /proc/self/status. Returns: bytes.
std::optional<double> status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name + ":")) return 1024 * std::stod(line.substr(name.size() + 1));
  return std::nullopt;
}

/// Resets the peak to the present value. Requires Linux 4.0 or later.
bool reset_peak() {
  std::ofstream control("/proc/self/clear_refs");
  control << "5" << std::flush;
  return control.good();
}

}  // namespace

std::optional<double> rise_of_peak(const std::function<void()>& work) {
  malloc_trim(0);  // otherwise the work would reuse pages that are resident already
  const bool is_reset = reset_peak();
  const std::optional<double> before = status_bytes("VmRSS");
  work();
  const std::optional<double> peak = status_bytes("VmHWM");
  if (!is_reset || !before || !peak) return std::nullopt;
  return *peak - *before;
}

std::optional<double> resident_bytes() { return status_bytes("VmRSS"); }

std::optional<double> peak_bytes(const std::function<void()>& prepare, const std::function<void()>& work) {
  int ends[2];
  if (pipe(ends) != 0) return std::nullopt;
  const pid_t child = fork();
  if (child < 0) return std::nullopt;
  if (child == 0) {
    close(ends[0]);
    bool complete = false;
    try {
      prepare();
      if (const std::optional<double> bytes = rise_of_peak(work))
        complete = write(ends[1], &*bytes, sizeof(double)) == sizeof(double);
    } catch (...) {  // nothing is reported
    }
    _exit(complete ? 0 : 1);
  }
  close(ends[1]);
  double bytes = 0;
  const bool complete = read(ends[0], &bytes, sizeof bytes) == sizeof bytes;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return complete ? std::optional(bytes) : std::nullopt;
}

void keep_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
}

}  // namespace rbpa_bench
