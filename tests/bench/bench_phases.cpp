// Measures the phases of rbpa(), in one thread: the tables of docs/reference/performance.md.
//   bench_phases [--runs=N] [--points=N] [--alpha=SPACINGS]
//                the least of 5 runs, 1,000,000 points, no radius; alpha in mean spacings of each set
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include "bench/arguments.h"
#include "bench/memory.h"
#include "bench/workload.h"
#include "rbpa/plane/mesh/assembly.h"
#include "rbpa/plane/patches/find_patch.h"
#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/remainder/remainder.h"
#include "rbpa/plane/tile/for_each_tile.h"
#include "support/spacing.h"

namespace rbpa_bench {
namespace {

enum Phase { sort, cut, triangulate, place, add, fill, complete, join, finish, phases };

constexpr std::array<const char*, phases> names = {
    "points into cells",   "cutting tiles",           "triangulating them",    "placing them", "what tiles leave over",
    "filling in the mesh", "completing what is left", "laying and joining it", "finish"};

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

/// Runs rbpa() step by step.
Seconds run(const rbpa_test::Points& points, const rbpa::Radius& radius) {
  Seconds seconds{};
  rbpa::SolidAlphaComplex complex;
  rbpa::Threads threads;
  Stopwatch watch(seconds);
  rbpa::Assembly assembly(points, complex, threads);
  const rbpa::Sites& sites = assembly.sites();
  const rbpa::PointGrid& grid = sites.grid();
  meshops::PatchAssembler assembler = assembly.assembler();
  rbpa::Remainder remainder(sites, radius);
  assembler.reserve(3 * grid.points().size(), 2 * grid.points().size());
  watch.lap(sort);
  rbpa::Cutter cutter(grid);
  rbpa::Tile tile;
  rbpa::FinderWorkspace workspace;
  rbpa::TilePatch triangles;
  meshops::Placement placement;
  const std::vector<rbpa::Block> blocks = rbpa::blocks(grid, rbpa::points_per_tile);
  watch.lap(cut);
  for (const rbpa::Block& block : blocks) {
    cutter.cut(block, tile);
    watch.lap(cut);
    rbpa::find_patch(tile, radius, workspace, triangles);
    watch.lap(triangulate);
    const meshops::Patch& patch = triangles.patch;
    const meshops::Outline& outline = triangles.outline;
    assembler.place(patch, outline, placement);
    watch.lap(place);
    remainder.add(triangles);
    watch.lap(add);
    assembler.fill(patch, outline, placement);
    watch.lap(fill);
  }
  rbpa::TilePatch rest;
  remainder.complete(
      threads, [] {}, rest);
  watch.lap(complete);
  assembler.lay(rest.patch, rest.outline);
  meshops::AssembledPatches assembled = std::move(assembler).join();
  watch.lap(join);
  assembly.finish(std::move(assembled));
  watch.lap(finish);
  return seconds;
}

void report(const Arguments& arguments) {
  const std::vector<Workload> workloads = {uniform, grid, clusters, kuzmin, lidar};
  std::vector<Seconds> best;
  std::printf("|");
  for (const Workload& workload : workloads) {
    const rbpa_test::Points points = workload.make(arguments.points);
    const rbpa::Radius radius = std::isfinite(arguments.alpha)
                                    ? rbpa::Radius(arguments.alpha * rbpa_test::mean_spacing(points))
                                    : rbpa::Radius();
    Seconds& least = best.emplace_back();
    least.fill(std::numeric_limits<double>::infinity());
    for (int i = 0; i < arguments.runs; ++i) {
      const Seconds seconds = run(points, radius);
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
  const auto arguments = rbpa_bench::parse(argc, argv, {.alpha = true});
  if (!arguments) return 2;
  rbpa_bench::keep_memory();
  rbpa_bench::report(*arguments);
}
