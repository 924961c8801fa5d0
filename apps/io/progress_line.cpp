#include "io/progress_line.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <system_error>
#include <utility>

namespace rbpa::app {
namespace {

/// A block of all signals while the object exists. Threads that this thread starts meanwhile inherit the block, so that
/// signals reach the threads that wait for files, and their read() returns.
class WithoutSignals {
 public:
  WithoutSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~WithoutSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;

 private:
  sigset_t before_{};
};

constexpr const char* clear = "\r\x1b[K";

}  // namespace

std::string short_number(double value) {
  const char* unit = "";
  for (const char* larger : {" k", " M", " G"}) {
    if (value < 999.5) break;
    value /= 1000;
    unit = larger;
  }
  char text[32];
  const int decimals = *unit == '\0' || value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
  std::snprintf(text, sizeof text, "%.*f%s", decimals, value, unit);
  return text;
}

std::string short_duration(double seconds) {
  constexpr double minute = 60, hour = 3600;
  if (seconds < 2 * minute) return short_number(std::floor(seconds)) + " s";
  if (seconds < 2 * hour) return short_number(std::floor(seconds / minute)) + " min";
  return short_number(std::floor(seconds / hour)) + " h";
}

ProgressLine::ProgressLine(std::string program, bool wanted, const std::string& doing)
    : program_(std::move(program)), text_([doing](double seconds) { return doing + ", " + short_duration(seconds); }) {
  if (!wanted || isatty(STDERR_FILENO) != 1) return;
  const std::lock_guard lock(mutex_);
  try {
    const WithoutSignals block;
    thread_.emplace([this] { run(); });
  } catch (const std::system_error&) {
    return;  // run without the line, as no thread is available
  }
  show();
}

ProgressLine::~ProgressLine() {
  if (!thread_) return;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  wake_.notify_one();
  thread_->join();
  std::fputs(clear, stderr);
}

void ProgressLine::say(Text text) {
  if (!thread_) return;
  const std::lock_guard lock(mutex_);
  text_ = std::move(text);
  show();
}

bool read_from_terminal(const std::string& path) { return path == "-" && isatty(STDIN_FILENO) == 1; }

bool written_to_terminal(const std::vector<std::string>& paths) {
  return std::find(paths.begin(), paths.end(), "-") != paths.end() && isatty(STDOUT_FILENO) == 1;
}

void ProgressLine::run() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::milliseconds(200), [this] { return ended_; })) show();
}

void ProgressLine::show() {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  std::fprintf(stderr, "%s%s: %s", clear, program_.c_str(), text_(seconds).c_str());
  std::fflush(stderr);
}

}  // namespace rbpa::app
