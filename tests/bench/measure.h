// What: a contest: several contestants on the same points, in turn, and the results of each.
// Law:  no contestant is left out: one that fails is reported as failed, one that finds other triangles than the first as
//       wrong.
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
  bool warm = false;          ///< one more round before, which does not count
  bool check = false;         ///< compare the triangles themselves, not only their number
  bool by_processor = false;  ///< seconds are those of the processor, which others on the machine disturb less
  double patience = 60;       ///< seconds after which a contestant is not run again
};

struct Task {
  Workload workload;
  std::size_t count;
  double alpha;
  std::string alpha_text;  ///< alpha as tables have it, in a unit that suits the points
};

/// How one contestant did.
struct Outcome {
  std::string contestant;
  Timings seconds;
  std::size_t triangles = 0;
  Clock clock = Clock::here;
  std::optional<double> bytes;  ///< peak beyond the input; of another program all of it
  std::string failure;          ///< why it has no result, or it is empty
  std::string wrong;            ///< how its result differs from that of the first contestant, or it is empty

  bool is_good() const { return failure.empty() && wrong.empty(); }
};

struct Contest {
  std::string set, alpha_text;
  std::size_t points = 0;
  std::vector<Outcome> outcomes;

  /// Absent when the contestant was not there.
  const Outcome* of(const std::string& contestant) const;
  double nanoseconds_a_point(const Outcome& outcome) const {
    return 1e9 * outcome.seconds.median() / static_cast<double>(points);
  }
};

/// By how many bytes resident memory rises at most beyond the input, in a process of its own; of another program, from its
/// runs. That process is forked: threads of this process are missing there, so call it before any contest.
std::optional<double> weigh(const Task& task, const Contestant& contestant);

/// All in turn, each round beginning with another one, as long as patience lasts.
/// The first contestant is the reference for the others: their number of triangles where they take alpha or it is
/// infinite, and on request the triangles, for those that list them.
Contest measure(const Task& task, const std::vector<Contestant>& contestants, const Settings& settings);

/// How many times the time of `ours` that of `peer` is; absent where one was not there or is not good.
std::optional<double> speedup(const Contest& contest, const std::string& ours, const std::string& peer);

}  // namespace rbpa_bench
