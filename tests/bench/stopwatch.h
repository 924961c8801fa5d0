// What: measures the time since its construction, by the wall clock and by the processor.
#pragma once

#include <chrono>
#include <ctime>

namespace rbpa_bench {

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  /// Returns the processor time of all threads of this process; with one thread, this is its time on a machine without
  /// other work.
  double processor_seconds() const { return processor_now() - processor_start_; }

 private:
  using Clock = std::chrono::steady_clock;
  static double processor_now() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  double processor_start_ = processor_now();
  Clock::time_point start_ = Clock::now();
};

}  // namespace rbpa_bench
