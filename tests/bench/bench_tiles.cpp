// Measures how much of the complex tiles decide: docs/explanation/plane.md, section 11.
//   bench_tiles [--points=N]      1,000,000 points, traps a tenth of them
#include <cmath>
#include <cstdio>

#include "bench/options.h"
#include "bench/tables.h"
#include "bench/workload.h"
#include "rbpa/plane/grid/point_grid.h"
#include "rbpa/plane/patches/find_patch.h"
#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/tile/for_each_tile.h"
#include "rbpa/rbpa.h"

namespace rbpa_bench {
namespace {

struct FoundByTiles {
  std::size_t tiles = 0, triangles = 0, settled = 0;
};

FoundByTiles found_by_tiles(const rbpa::Sites& sites, double alpha) {
  FoundByTiles by_tiles;
  struct Workspace {
    rbpa::FinderWorkspace finder;
    rbpa::TilePatch found;
  };
  rbpa::Threads threads;
  const rbpa::Radius radius = sites.window().scaled(rbpa::Radius::of(alpha));
  rbpa::for_each_tile<Workspace>(
      sites, threads, [](std::size_t) { return true; },
      [&](const rbpa::Tile& tile, Workspace& w) { find_patch(tile, radius, w.finder, w.found); },
      [&](std::size_t, Workspace& w) {
        ++by_tiles.tiles;
        by_tiles.triangles += w.found.patch.triangles.size();
        by_tiles.settled += w.found.settled.size();
      },
      [](Workspace&) {});
  return by_tiles;
}

/// Returns the number of points of all tiles, including the ghosts around them.
std::size_t points_of_tiles(const rbpa::PointGrid& grid) {
  rbpa::Cutter cutter(grid);
  rbpa::Tile tile;
  std::size_t points = 0;
  for (const rbpa::Block& block : rbpa::blocks(grid, rbpa::points_per_tile)) {
    cutter.cut(block, tile);
    points += tile.points.size();
  }
  return points;
}

void measure(const std::string& set, const rbpa_test::Points& points, double alpha) {
  rbpa::Threads threads;
  const rbpa::Sites sites(points, threads);
  const rbpa::PointGrid& grid = sites.grid();
  const FoundByTiles by_tiles = found_by_tiles(sites, alpha);
  const std::size_t triangles = rbpa::rbpa(points, alpha).mesh.n_faces();
  const auto share = [](std::size_t part, std::size_t of) {
    return static_cast<double>(part) / static_cast<double>(of);
  };
  const std::size_t distinct = grid.points().size();
  print_row({set, text("%zu", points.size()), std::isinf(alpha) ? "∞" : text("%g", alpha), text("%zu", triangles),
             text("%zu", by_tiles.tiles), text("%.2f", 100 * share(by_tiles.triangles, triangles)),
             text("%zu", triangles - by_tiles.triangles), text("%.2f", 100 * share(by_tiles.settled, distinct)),
             text("%.2f", share(points_of_tiles(grid), distinct))});
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const std::size_t count = read_sizes(argc, argv).points;
  std::printf("Points of tiles: as a multiple of their own points.\n\n");
  print_head({"points"},
             {"number", "α", "triangles", "tiles", "found on tiles, %", "left over", "settled points, %", "of tiles"});
  for (const Workload& workload : {uniform, jittered, grid, clusters, kuzmin, lidar})
    measure(workload.name, workload.make(count), INFINITY);
  for (const Workload& trap : {circle_line_cluster, concentric, curves})
    measure(trap.name, trap.make(count / 10), INFINITY);
  measure(uniform.name, uniform.make(count), 3);
}
