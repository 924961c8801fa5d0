#include "bench/watched_run.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "bench/stopwatch.h"

namespace rbpa_bench {
namespace {

namespace fs = std::filesystem;

double bytes_in(const fs::path& folder) {
  double bytes = 0;
  std::error_code error;  // files can disappear during the scan
  for (auto file = fs::recursive_directory_iterator(folder, error); !error && file != fs::end(file);
       file.increment(error)) {
    std::error_code gone;
    const std::uintmax_t size = file->is_regular_file(gone) ? file->file_size(gone) : 0;
    if (!gone) bytes += static_cast<double>(size);
  }
  return bytes;
}

/// Reads the processor time: words 14 and 15 of a line whose second word is a name in brackets.
double processor_seconds_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(file, line);
  std::istringstream words(line.substr(std::min(line.rfind(')') + 1, line.size())));
  std::string word;
  constexpr int before = 11;
  for (int i = 0; i < before; ++i) words >> word;
  double user = 0, system = 0;
  words >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double resident_bytes_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  double size = 0, resident = 0;
  file >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

Moment look_at(pid_t process, double seconds, const std::string& scratch) {
  Moment moment{seconds, processor_seconds_of(process), resident_bytes_of(process)};
  if (scratch.empty()) return moment;
  moment.tile_bytes = bytes_in(scratch + "/tiles");
  moment.scratch_bytes = bytes_in(scratch);
  return moment;
}

pid_t start(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) {
    execv(words[0], words.data());
    _exit(127);
  }
  return child;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

double WatchedRun::processor_seconds_at(double at) const {
  Moment before{}, after{seconds, processor_seconds};
  for (const Moment& moment : moments) {
    if (moment.seconds <= at) before = moment;
    if (moment.seconds > at && moment.seconds < after.seconds) after = moment;
  }
  const double wide = after.seconds - before.seconds;
  const double share = wide > 0 ? std::clamp((at - before.seconds) / wide, 0.0, 1.0) : 1;
  return before.processor_seconds + share * (after.processor_seconds - before.processor_seconds);
}

WatchedRun run_watched(const std::vector<std::string>& command, const std::string& scratch) {
  const Stopwatch watch;
  const pid_t child = start(command);
  WatchedRun run;
  int status = 0;
  rusage usage{};
  constexpr double rest = 0.05, part = 100;
  for (double next = 0; wait4(child, &status, WNOHANG, &usage) == 0;) {
    const double now = watch.seconds();
    if (now >= next) {
      const Moment moment = look_at(child, now, scratch);
      if (moment.resident_bytes > 0) run.moments.push_back(moment);  // 0 while the process ends
      next = now + std::max(rest, part * (watch.seconds() - now));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  run.seconds = watch.seconds();
  run.processor_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  constexpr double kibibyte = 1024;
  run.peak_bytes = kibibyte * static_cast<double>(usage.ru_maxrss);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error(
        command[0] + " " + command[1] + ": ended with " +
        (WIFEXITED(status) ? std::to_string(WEXITSTATUS(status)) : "signal " + std::to_string(WTERMSIG(status))) +
        ", expected 0");
  return run;
}

}  // namespace rbpa_bench
