// Where the time of rbpa() goes, in one thread without a radius: the table of docs/performance.md.
//   bench_phases [--runs=N] [--points=N]      the least of 5 runs, 1,000,000 points
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <vector>

#include "bench/arguments.h"
#include "bench/memory.h"
#include "bench/workload.h"
#include "rbpa/pivot/radius.h"
#include "rbpa/remainder/remainder.h"
#include "rbpa/run/assembly.h"
#include "rbpa/tile/for_each_tile.h"

namespace rbpa_bench {
namespace {

enum Phase { sort, cut, triangulate, survey, place, add, fill, complete, join, finish, phases };

constexpr std::array<const char*, phases> names = {
    "points into cells",     "cutting tiles",       "triangulating them",      "survey of patches",     "placing them",
    "what tiles leave over", "filling in the mesh", "completing what is left", "laying and joining it", "finish"};

using Seconds = std::array<double, phases>;

class Stopwatch {
 public:
  explicit Stopwatch(Seconds& seconds) : seconds_(seconds) {}
  void lap(Phase phase) {
    const Clock::time_point now = Clock::now();
    seconds_[phase] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Seconds& seconds_;
  Clock::time_point last_ = Clock::now();
};

/// rbpa() step by step.
Seconds run(const rbpa_test::Points& points) {
  Seconds seconds{};
  rbpa::SolidAlphaComplex complex;
  rbpa::Threads threads;
  const rbpa::Radius infinite;
  Stopwatch watch(seconds);
  rbpa::Assembly<double> assembly(points, complex, threads);
  const rbpa::PointGrid<double>& grid = assembly.grid();
  meshops::Front& front = assembly.front();
  rbpa::Remainder remainder(grid.points(), infinite);
  front.reserve(3 * grid.points().size(), 2 * grid.points().size());
  watch.lap(sort);
  rbpa::Cutter cutter(grid);
  rbpa::Tile tile;
  rbpa::TileWorkspace workspace;
  rbpa::ToldTile told;
  const std::vector<rbpa::Block> blocks = rbpa::blocks(grid, rbpa::points_per_tile);
  watch.lap(cut);
  for (const rbpa::Block& block : blocks) {
    cutter.cut(block, tile);
    watch.lap(cut);
    rbpa::triangulate(tile, infinite, workspace, told.triangles);
    watch.lap(triangulate);
    told.placement.survey(told.triangles.patch);
    watch.lap(survey);
    front.place(told.triangles.patch, told.placement);
    watch.lap(place);
    remainder.add(told.triangles);
    watch.lap(add);
    front.fill(told.triangles.patch, told.placement);
    watch.lap(fill);
  }
  meshops::Patch missing;
  remainder.complete(missing, threads, [] {});
  watch.lap(complete);
  front.lay(missing);
  front.join();
  watch.lap(join);
  assembly.finish();
  watch.lap(finish);
  return seconds;
}

void report(const Arguments& arguments) {
  const std::vector<Workload> workloads = {uniform, grid, clusters, kuzmin, lidar};
  std::vector<Seconds> best;
  std::printf("|");
  for (const Workload& workload : workloads) {
    const rbpa_test::Points points = workload.make(arguments.points);
    Seconds& least = best.emplace_back();
    least.fill(std::numeric_limits<double>::infinity());
    for (int i = 0; i < arguments.runs; ++i) {
      const Seconds seconds = run(points);
      for (std::size_t phase = 0; phase < phases; ++phase)
        least[phase] = std::min(least[phase], 1e9 * seconds[phase] / static_cast<double>(points.size()));
    }
    std::printf(" | %s", workload.name.c_str());
  }
  std::printf(" |\n|---|");
  for (std::size_t i = 0; i < workloads.size(); ++i) std::printf("--:|");
  for (std::size_t phase = 0; phase < phases; ++phase) {
    std::printf("\n| %s", names[phase]);
    for (const Seconds& least : best) std::printf(" | %.1f", least[phase]);
    std::printf(" |");
  }
  std::printf("\n");
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const auto arguments = rbpa_bench::parse(argc, argv);
  if (!arguments) return 2;
  rbpa_bench::keep_memory();
  rbpa_bench::report(*arguments);
}
