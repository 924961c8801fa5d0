// What: measures contestants in turn, on the same input, by the clock and by the processor.
// Law:  no contestant is left out: one that fails is reported as failed, and one whose result has another size than
//       that of the first as wrong.
#pragma once

#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace rbpa_bench {

/// One measured run, and the size of its result, such as a number of triangles.
struct Run {
  double seconds = 0;            ///< from the input in memory to the finished result; freeing it is not counted
  double processor_seconds = 0;  ///< of all threads
  std::size_t count = 0;
};

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  /// Returns the processor time of all threads of this process; with one thread, this is its time on a machine without
  /// other work.
  double processor_seconds() const { return processor_now() - processor_start_; }
  Run run(std::size_t count) const { return {seconds(), processor_seconds(), count}; }

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

/// Times of repeated runs, in one unit.
struct Timings {
  std::vector<double> of;

  double sum() const;
  double least() const { return share(0); }
  /// Returns the lower quartile: the cost of a run that is little disturbed.
  double lower_quartile() const { return share(0.25); }
  double median() const;
  /// Returns a text: median (least–most), each times `unit`.
  std::string text(int digits = 0, double unit = 1) const;

 private:
  /// Returns the time that this share of the runs does not exceed; NaN when there are none.
  double share(double part) const;
};

struct Contestant {
  std::string name;
  std::function<Run()> run;  ///< throws when there is no result
  bool is_exact = true;      ///< its result has the size of the first one's
};

struct Settings {
  int runs = 5;
  bool warm = false;          ///< run one round before, which does not count
  bool by_processor = false;  ///< measure processor seconds, which other processes disturb less
};

/// Results of one contestant.
struct Outcome {
  std::string name;
  Timings seconds = {};
  std::size_t count = 0;
  double bytes = NAN;        ///< peak beyond the input, where it was measured
  std::string failure = {};  ///< why it has no result; empty if it has one
  std::string wrong = {};    ///< how its result differs from that of the first contestant; empty if it does not

  bool is_good() const { return failure.empty() && wrong.empty() && !seconds.of.empty(); }
};

/// Runs all contestants in turn, each round beginning with another one. One that took more than a minute in all is not
/// run again.
std::vector<Outcome> in_turn(const std::vector<Contestant>& contestants, const Settings& settings);

/// Outcomes on one set of points.
struct Contest {
  std::string set, alpha;  ///< alpha in a unit that suits the points
  std::size_t points;
  std::vector<Outcome> outcomes;

  /// Return the median of a contestant in nanoseconds a point, and how many times as long as another one it took; NaN
  /// when one of them is missing or has no valid result.
  double nanoseconds(const std::string& name) const;
  double ratio(const std::string& name, const std::string& other) const {
    return nanoseconds(name) / nanoseconds(other);
  }
};

}  // namespace rbpa_bench
