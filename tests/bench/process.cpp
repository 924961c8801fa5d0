#include "bench/process.h"

#include <malloc.h>
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace rbpa_bench {
namespace {

/// Reads a line "name:  1234 kB" of /proc/self/status. Returns: bytes.
double status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name + ":")) return 1024 * std::stod(line.substr(name.size() + 1));
  return NAN;
}

/// Resets the peak to the present value. Requires Linux 4.0 or later.
bool reset_peak() {
  std::ofstream control("/proc/self/clear_refs");
  control << "5" << std::flush;
  return control.good();
}

}  // namespace

double rise_of_peak(const std::function<void()>& work) {
  malloc_trim(0);  // otherwise the work would reuse pages that are resident already
  const bool is_reset = reset_peak();
  const double before = status_bytes("VmRSS");
  work();
  return is_reset ? status_bytes("VmHWM") - before : NAN;
}

PeerProgram::PeerProgram(const std::string& argument)
    : name_(argument.substr(0, argument.find('='))),
      command_(argument.substr(std::min(name_.size() + 1, argument.size()))) {
  if (name_.empty() || command_.empty())
    throw std::invalid_argument("--peer: found '" + argument + "', expected NAME=COMMAND");
}

double PeerProgram::run_in(const Folder& folder) const {
  const std::string errors = folder / "errors";
  std::fflush(stdout);
  const auto start = std::chrono::steady_clock::now();
  const int status = std::system((command_ + " '" + (folder / "points") + "' '" + (folder / "result") +
                                  "' </dev/null >/dev/null 2>'" + errors + "'")
                                     .c_str());
  double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::string last;
  std::ifstream file(errors);
  for (std::string line; std::getline(file, line);) {
    std::sscanf(line.c_str(), "seconds %lf", &seconds);
    if (!line.empty()) last = ": " + line;
  }
  if (WIFSIGNALED(status)) throw std::runtime_error("ended by signal " + std::to_string(WTERMSIG(status)) + last);
  if (WEXITSTATUS(status) != 0) throw std::runtime_error("ended with " + std::to_string(WEXITSTATUS(status)) + last);
  return seconds;
}

void keep_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
}

std::vector<double> run_again(const std::string& arguments, std::size_t numbers) {
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  std::FILE* const output = popen(("exec '" + program + "' " + arguments).c_str(), "r");
  if (!output) throw std::runtime_error("no process can be started");
  std::vector<double> values;
  for (double value = 0; std::fscanf(output, "%lf", &value) == 1;) values.push_back(value);
  if (pclose(output) != 0 || values.size() != numbers)
    throw std::runtime_error(arguments + ": the process reported nothing");
  return values;
}

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "rbpa_bench_XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error(name + ": cannot be made");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace rbpa_bench
