#include "bench/measure.h"

#include <algorithm>
#include <exception>
#include <numeric>

#include "bench/tables.h"

namespace rbpa_bench {

double Timings::sum() const { return std::accumulate(of.begin(), of.end(), 0.0); }

double Timings::share(double part) const {
  if (of.empty()) return NAN;
  std::vector<double> sorted = of;
  std::sort(sorted.begin(), sorted.end());
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

double Timings::median() const {
  if (of.empty()) return NAN;
  std::vector<double> sorted = of;
  std::sort(sorted.begin(), sorted.end());
  return (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]) / 2;
}

std::string Timings::text(int digits, double unit) const {
  return rbpa_bench::text("%.*f (%.*f–%.*f)", digits, unit * median(), digits, unit * least(), digits, unit * share(1));
}

std::vector<Outcome> in_turn(const std::vector<Contestant>& contestants, const Settings& settings) {
  constexpr double patience = 60;
  std::vector<Outcome> outcomes;
  for (const Contestant& contestant : contestants) outcomes.push_back({contestant.name});
  for (int round = settings.warm ? -1 : 0; round < settings.runs; ++round) {
    for (std::size_t turn = 0; turn < contestants.size(); ++turn) {
      const std::size_t i = (turn + static_cast<std::size_t>(std::max(round, 0))) % contestants.size();
      Outcome& outcome = outcomes[i];
      if (!outcome.failure.empty() || outcome.seconds.sum() > patience) continue;
      try {
        const Run run = contestants[i].run();
        outcome.seconds.of.push_back(settings.by_processor ? run.processor_seconds : run.seconds);
        outcome.count = run.count;
      } catch (const std::exception& error) {
        outcome.failure = error.what();
      }
    }
    if (round >= 0) continue;
    for (Outcome& outcome : outcomes)
      if (outcome.seconds.sum() <= patience) outcome.seconds.of.clear();
  }
  for (std::size_t i = 1; i < contestants.size(); ++i)
    if (contestants[i].is_exact && outcomes[0].failure.empty() && outcomes[i].failure.empty() &&
        outcomes[i].count != outcomes[0].count)
      outcomes[i].wrong = text("found %zu, expected %zu", outcomes[i].count, outcomes[0].count);
  return outcomes;
}

double Contest::nanoseconds(const std::string& name) const {
  for (const Outcome& outcome : outcomes)
    if (outcome.name == name && outcome.is_good()) return 1e9 * outcome.seconds.median() / static_cast<double>(points);
  return NAN;
}

}  // namespace rbpa_bench
