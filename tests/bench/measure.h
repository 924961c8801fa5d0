// What: runs a contest: several contestants on the same points, in turn.
// Law:  no contestant is left out: one that fails is reported as failed, and one that finds other triangles than the
//       first as wrong.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/contest.h"
#include "bench/timings.h"
#include "bench/workload.h"

namespace rbpa_bench {

struct Settings {
  int runs = 5;
  bool warm = false;          ///< run one round before, which does not count
  bool check = false;         ///< compare the triangles themselves, not only their number
  bool by_processor = false;  ///< measure processor seconds, which other processes disturb less
  double patience = 60;       ///< seconds after which a contestant is not run again
};

struct Task {
  Workload workload;
  std::size_t count;
  double alpha;
  std::string alpha_text;  ///< alpha for tables, in a unit that suits the points
};

/// Results of one contestant.
struct Outcome {
  std::string contestant;
  Timings seconds;
  std::size_t triangles = 0;
  Clock clock = Clock::here;
  std::optional<double> bytes;  ///< peak beyond the input; for another program, its whole peak
  std::string failure;          ///< why it has no result; empty if it has one
  std::string wrong;            ///< how its result differs from that of the first contestant; empty if it does not

  bool is_good() const { return failure.empty() && wrong.empty(); }
};

struct Contest {
  std::string set, alpha_text;
  std::size_t points = 0;
  std::vector<Outcome> outcomes;

  /// Returns the results of a contestant; null when it did not take part.
  const Outcome* of(const std::string& contestant) const;
  double nanoseconds_a_point(const Outcome& outcome) const {
    return 1e9 * outcome.seconds.median() / static_cast<double>(points);
  }
};

/// Returns the peak rise of resident memory beyond the input, in bytes, in a process of its own; for another program,
/// from its runs. That process is forked and lacks the threads of this process, so call it before any contest.
std::optional<double> weigh(const Task& task, const Contestant& contestant);

/// Runs all contestants in turn, each round beginning with another one, as long as patience lasts.
/// The first contestant is the reference for the others: they must find its number of triangles if they take alpha or
/// it is infinite, and on request the same triangles, if they list them.
Contest measure(const Task& task, const std::vector<Contestant>& contestants, const Settings& settings);

/// Returns the time of `peer` divided by that of `ours`; nothing when one of them is missing or has no valid result.
std::optional<double> speedup(const Contest& contest, const std::string& ours, const std::string& peer);

}  // namespace rbpa_bench
