// Measures the phases of rbpa(), in one thread: the tables of docs/reference/performance.md.
//   bench_phases [--runs=N] [--points=N]      the least of 5 runs, 1,000,000 points
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "bench/measure.h"
#include "bench/options.h"
#include "bench/process.h"
#include "bench/tables.h"
#include "bench/workload.h"
#include "rbpa/plane/mesh/assembly.h"
#include "rbpa/plane/patches/find_patch.h"
#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/remainder/remainder.h"
#include "rbpa/plane/tile/for_each_tile.h"

namespace rbpa_bench {
namespace {

enum Phase { sort, cut, triangulate, place, add, fill, complete, join, finish, phases };

constexpr std::array<const char*, phases> names = {
    "points into cells",   "cutting tiles",           "triangulating them",    "placing them", "what tiles leave over",
    "filling in the mesh", "completing what is left", "laying and joining it", "finish"};

using Seconds = std::array<double, phases>;

/// A stopwatch: lap(phase) adds the time since the last lap to the phase.
class Laps {
 public:
  explicit Laps(Seconds& seconds) : seconds_(seconds) {}
  void lap(Phase phase) {
    seconds_[phase] += watch_.seconds();
    watch_ = {};
  }

 private:
  Seconds& seconds_;
  Stopwatch watch_ = {};
};

/// Runs rbpa() step by step.
Seconds run(const rbpa_test::Points& points) {
  const rbpa::Radius radius;  // none
  Seconds seconds{};
  rbpa::SolidAlphaComplex complex;
  rbpa::Threads threads;
  Laps watch(seconds);
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

void report(const Sizes& sizes) {
  const std::vector<Workload> workloads = {uniform, grid, clusters, kuzmin, lidar};
  std::vector<Seconds> least(workloads.size());
  for (std::size_t i = 0; i < workloads.size(); ++i) {
    const rbpa_test::Points points = workloads[i].make(sizes.points);
    least[i].fill(INFINITY);
    for (int times = 0; times < sizes.runs; ++times) {
      const Seconds seconds = run(points);
      for (std::size_t phase = 0; phase < phases; ++phase)
        least[i][phase] = std::min(least[i][phase], 1e9 * seconds[phase] / static_cast<double>(points.size()));
    }
  }
  print_head({""}, columns({}, workloads));
  for (std::size_t phase = 0; phase < phases; ++phase) {
    std::vector<std::string> cells = {names[phase]};
    for (const Seconds& of : least) cells.push_back(text("%.1f", of[phase]));
    print_row(cells);
  }
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  const rbpa_bench::Sizes sizes = rbpa_bench::read_sizes(argc, argv);
  rbpa_bench::keep_memory();
  rbpa_bench::report(sizes);
}
