// rbpa() and its peer side by side. `per_point` is time for a point, `bytes_per_point` the peak of resident memory
// beyond the input.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "bench/contest.h"
#include "bench/memory.h"

namespace rbpa_bench {
namespace {

void measure(benchmark::State& state, const Contestant& contestant, const Workload& workload, std::size_t count,
             double alpha) {
  rbpa_test::Points points;
  const auto bytes = peak_bytes([&] { points = workload.make(count); },
                                [&] { benchmark::DoNotOptimize(contestant.run(points, alpha)); });
  points = workload.make(count);
  std::size_t triangles = 0;
  for ([[maybe_unused]] const auto _ : state) {
    const Run run = contestant.run(points, alpha);
    state.SetIterationTime(run.seconds);
    triangles = run.triangles;
  }
  const auto size = static_cast<double>(points.size());
  state.counters["per_point"] =
      benchmark::Counter(size, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["triangles"] = static_cast<double>(triangles);
  if (bytes) state.counters["bytes_per_point"] = *bytes / size;
}

void add(const Contestant& contestant, const Workload& workload, std::size_t count, double alpha) {
  const std::string size =
      count >= 1000000 ? std::to_string(count / 1000000) + "M" : std::to_string(count / 1000) + "k";
  const std::string name = std::string(workload.name) + "/" + size +
                           "/alpha:" + (std::isinf(alpha) ? "inf" : std::to_string(static_cast<int>(alpha))) + "/" +
                           std::string(contestant.name);
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) { measure(state, contestant, workload, count, alpha); })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

void add_all() {
  for (const double alpha : {3.0, double(INFINITY)})
    for (const Workload& workload : {uniform, jittered, grid})
      for (const Contestant& contestant : {rbpa_near_to_far, cgal}) add(contestant, workload, 1000000, alpha);
  for (const std::size_t count : {std::size_t{100000}, std::size_t{4000000}})  // growth, with the million above
    for (const Contestant& contestant : {rbpa_near_to_far, cgal}) add(contestant, uniform, count, 3);
  add(rbpa_paper_grid, uniform, 100000, 3);
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  rbpa_bench::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
