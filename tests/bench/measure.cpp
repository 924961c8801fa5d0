#include "bench/measure.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "bench/memory.h"

namespace rbpa_bench {
namespace {

/// Returns triangles in a form that does not depend on orientation, order and repetitions: corners ascending, the
/// lowest of equal points, sorted.
Triangles as_set(Triangles triangles, const std::vector<std::uint32_t>& lowest) {
  for (rbpa_test::Triangle& t : triangles) {
    for (std::uint32_t& corner : t) corner = lowest[corner];
    std::sort(t.begin(), t.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Runs a contestant. Returns: false, with the reason in `outcome`, when there is no result.
bool run(const Contestant& contestant, std::span<const rbpa::Point> points, double alpha, Triangles* list,
         Outcome& outcome, bool by_processor = false) {
  try {
    const Run one = contestant.run(points, alpha, list);
    outcome.seconds.of.push_back(by_processor ? one.processor_seconds.value_or(one.seconds) : one.seconds);
    outcome.triangles = one.triangles;
    outcome.clock = one.clock;
    if (one.process_bytes) outcome.bytes = std::max(outcome.bytes.value_or(0), *one.process_bytes);
    return true;
  } catch (const std::exception& error) {
    outcome.failure = error.what();
    return false;
  }
}

bool finds_the_same(const Contestant& contestant, double alpha) { return contestant.takes_alpha || std::isinf(alpha); }

void compare_numbers(const Contestant& contestant, double alpha, const Outcome& reference, Outcome& outcome) {
  if (finds_the_same(contestant, alpha) && reference.failure.empty() && outcome.triangles != reference.triangles)
    outcome.wrong = std::to_string(outcome.triangles) + " triangles, expected " + std::to_string(reference.triangles);
}

void compare_sets(const std::vector<Contestant>& contestants, std::span<const rbpa::Point> points, double alpha,
                  std::vector<Outcome>& outcomes) {
  const std::vector<std::uint32_t> lowest = rbpa_test::lowest_equal(points);
  Triangles expected;
  if (contestants.empty()) return;
  contestants[0].run(points, alpha, &expected);
  expected = as_set(std::move(expected), lowest);
  for (std::size_t i = 1; i < contestants.size(); ++i) {
    if (!outcomes[i].is_good() || !finds_the_same(contestants[i], alpha)) continue;
    Triangles found, others;
    Outcome once;
    if (!run(contestants[i], points, alpha, &found, once)) {
      outcomes[i].failure = once.failure;
      continue;
    }
    if (found.empty() && once.triangles > 0) continue;  // it does not list its triangles
    found = as_set(std::move(found), lowest);
    std::set_difference(found.begin(), found.end(), expected.begin(), expected.end(), std::back_inserter(others));
    if (!others.empty() || found.size() != expected.size())
      outcomes[i].wrong =
          std::to_string(others.size()) + " of " + std::to_string(found.size()) + " triangles are others";
  }
}

}  // namespace

const Outcome* Contest::of(const std::string& contestant) const {
  const auto found = std::find_if(outcomes.begin(), outcomes.end(),
                                  [&](const Outcome& outcome) { return outcome.contestant == contestant; });
  return found == outcomes.end() ? nullptr : &*found;
}

std::optional<double> weigh(const Task& task, const Contestant& contestant) {
  if (contestant.is_program) return std::nullopt;
  rbpa_test::Points points;
  return peak_bytes([&] { points = task.workload.make(task.count); },
                    [&] { contestant.run(points, task.alpha, nullptr); });
}

Contest measure(const Task& task, const std::vector<Contestant>& contestants, const Settings& settings) {
  Contest contest{task.workload.name, task.alpha_text, 0, std::vector<Outcome>(contestants.size())};
  for (std::size_t i = 0; i < contestants.size(); ++i) contest.outcomes[i].contestant = contestants[i].name;
  const rbpa_test::Points points = task.workload.make(task.count);
  contest.points = points.size();
  const auto hold_round = [&](int round) {
    for (std::size_t turn = 0; turn < contestants.size(); ++turn) {
      const std::size_t i = (turn + static_cast<std::size_t>(round)) % contestants.size();
      Outcome& outcome = contest.outcomes[i];
      if (outcome.failure.empty() && (outcome.seconds.of.empty() || outcome.seconds.sum() <= settings.patience))
        run(contestants[i], points, task.alpha, nullptr, outcome, settings.by_processor);
    }
  };
  if (settings.warm) {
    hold_round(0);
    for (Outcome& outcome : contest.outcomes)
      if (outcome.seconds.sum() <= settings.patience) outcome.seconds.of.clear();
  }
  for (int round = 0; round < settings.runs; ++round) hold_round(round);
  for (std::size_t i = 1; i < contestants.size(); ++i)
    if (contest.outcomes[i].failure.empty())
      compare_numbers(contestants[i], task.alpha, contest.outcomes[0], contest.outcomes[i]);
  if (settings.check && !contestants.empty() && contest.outcomes[0].failure.empty())
    compare_sets(contestants, points, task.alpha, contest.outcomes);
  return contest;
}

std::optional<double> speedup(const Contest& contest, const std::string& ours, const std::string& peer) {
  const Outcome *one = contest.of(ours), *other = contest.of(peer);
  if (!one || !other || !one->is_good() || !other->is_good()) return std::nullopt;
  return other->seconds.median() / one->seconds.median();
}

}  // namespace rbpa_bench
