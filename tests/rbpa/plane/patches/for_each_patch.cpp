#include "rbpa/plane/patches/for_each_patch.h"
#include "rbpa/paper.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "meshops/core/validate.h"
#include "meshops/front/front.h"
#include "meshops/patch/assembler.h"
#include "rbpa/base/exact/magnitude.h"
#include "rbpa/base/mesh.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/rbpa.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/sets.h"
#include "support/spacing.h"
#include "support/tile_sets.h"

using namespace rbpa_test;
using rbpa::PointGrid;
using rbpa::Radius;

TEST_SUITE_BEGIN("patches");

namespace {

std::vector<Triangle> triangles_on(const meshops::Front& front) {
  std::vector<Triangle> found;
  for (std::size_t f = 0; f < front.faces(); ++f) {
    Triangle corners;
    auto h = front.mesh().halfedge_handle(meshops::Face(static_cast<int>(f)));
    for (auto& corner : corners) {
      corner = static_cast<std::uint32_t>(front.from_site(h));
      h = front.mesh().next_halfedge_handle(h);
    }
    found.push_back(corners);
  }
  return canonical(std::move(found));
}

/// Lays the tiles of a set. Returns the number of settled sites.
std::ptrdiff_t check_laid(const Points& input, const Radius& radius) {
  rbpa::Threads threads(2);
  const rbpa::Sites sites(input, threads);
  const PointGrid& grid = sites.grid();
  const Points points(grid.points().begin(), grid.points().end());
  std::vector<Triangle> complex = delaunay_by_winners(points);
  std::erase_if(complex,
                [&](const Triangle& t) { return !radius.admits<double>(points[t[0]], points[t[1]], points[t[2]]); });
  rbpa::Mesh mesh;
  meshops::PatchAssembler assembler(mesh, points.size());
  int tiles = 0;
  std::vector<bool> known(points.size(), false);
  assembler.reserve(3 * sites.size(), 2 * sites.size());
  struct Workspace {
    rbpa::FinderWorkspace finder;
    rbpa::TilePatch found;
    meshops::Placement placement;
  };
  rbpa::for_each_tile<Workspace>(
      sites, threads, [](std::size_t) { return true; },
      [&](const rbpa::Tile& tile, Workspace& w) { find_patch(tile, radius, w.finder, w.found); },
      [&](std::size_t i, Workspace& w) {
        CHECK(static_cast<int>(i) == tiles);
        assembler.place(w.found.patch, w.found.outline, w.placement);
        ++tiles;
        for (const std::uint32_t s : w.found.settled) known[s] = true;
      },
      [&](Workspace& w) { assembler.fill(w.found.patch, w.found.outline, w.placement); });
  meshops::Front front(std::move(assembler).join());
  CHECK(tiles == std::ssize(rbpa::blocks(grid, 2048)));
  REQUIRE(meshops::validate(mesh).empty());

  const std::vector<Triangle> laid = triangles_on(front);
  CHECK(std::adjacent_find(laid.begin(), laid.end()) == laid.end());
  REQUIRE(std::includes(complex.begin(), complex.end(), laid.begin(), laid.end()));
  std::vector<Triangle> missing;
  std::set_difference(complex.begin(), complex.end(), laid.begin(), laid.end(), std::back_inserter(missing));
  for (const Triangle& t : missing)
    for (const std::uint32_t s : t) CHECK_FALSE(known[s]);

  // The complex has no triangle beyond a frozen side, and an active side is on the boundary.
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const Triangle& t : complex)
    for (std::size_t i = 0; i < 3; ++i) sides.insert({t[i], t[(i + 1) % 3]});
  std::size_t on_boundary = 0;
  for (const auto h : mesh.halfedges()) on_boundary += h.is_boundary();
  for (const auto h : front.frozen()) {
    CHECK(mesh.is_boundary(h));
    CHECK_FALSE(
        sides.contains({static_cast<std::uint32_t>(front.from_site(h)), static_cast<std::uint32_t>(front.to_site(h))}));
  }
  on_boundary -= front.frozen().size();
  while (front.pop().is_valid()) --on_boundary;
  CHECK(on_boundary == 0);
  return std::count(known.begin(), known.end(), true);
}

/// Checks both searches on sets that tiles share unevenly.
void check_searches(const Points& points, const std::vector<double>& alphas) {
  for (const double alpha : alphas) {
    CAPTURE(alpha);
    const auto paper = rbpa::paper::rbpa(points, alpha);
    const auto tiles = rbpa::rbpa(points, alpha);
    CHECK(meshops::validate(tiles.mesh).empty());
    CHECK(difference(rbpa::triangles(paper), rbpa::triangles(tiles)) == "");
    CHECK(tiles.isolated == paper.isolated);
    CHECK(tiles.mesh.n_vertices() == paper.mesh.n_vertices());
    CHECK(tiles.mesh.n_edges() == paper.mesh.n_edges());
  }
}

Points together(Points a, const Points& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

TEST_CASE("laid patches are sound and in the complex; none is missing at settled sites or beyond frozen sides") {
  std::ptrdiff_t known = 0;
  for (const TileSet& set : tile_sets()) {
    CAPTURE(set.name);
    const double spacing = mean_spacing(set.points);
    for (const double alpha : {0.5 * spacing, spacing, infinity})
      known += check_laid(set.points, std::isinf(alpha) ? Radius() : Radius(alpha));
  }
  CHECK(known > 0);
}

TEST_CASE("both searches find the same where densities differ from tile to tile") {
  const Points crowd = moved(scaled(uniform(1200, 1), -8), 3, 20), thin = uniform(2500, 2);
  check_searches(together(thin, crowd), {0.05, 0.7, 2});
  check_searches(together(jittered_grid(50, 0.9, 3), moved(perfect_grid(30, 0x1p-5), 10.5, 10.25)), {0.03, 0.6, 1.5});
  check_searches(together(perfect_grid(60, 1), moved(perfect_grid(40, 0x1p-7), 20.5, 30.5)), {0.006, 0.71, 1});
  check_searches(together(uniform(3000, 4), moved(scaled(clusters(60, 5), -2), 20, 20)), {1e-3, 0.5, 1});
  check_searches(clusters(300, 6), {1e-6, 1e-3, 0.1});
}

TEST_CASE("both searches find the same with a point just off a lattice") {
  const Points points = {{-1e-20, 0}, {-2, -2}, {-2, 0}, {-2, 1}, {-2, 2}, {-1, -2}, {-1, -1},
                         {-1, 0},     {1, 0},   {1, 2},  {2, -1}, {2, 0},  {2, 1},   {2, 2}};
  check_searches(points, {1, 1.5, 1e9});
}

TEST_CASE("both searches find the same on tile sets and few points") {
  for (const TileSet& set : tile_sets()) {
    CAPTURE(set.name);
    const double spacing = mean_spacing(set.points);
    check_searches(set.points, {0.3 * spacing, spacing, 4 * spacing});
  }
  Random random(7);
  for (int round = 0; round < trials(300); ++round) {
    const TileSet set = few_points(random);
    CAPTURE(round);
    CAPTURE(set.name);
    const double spacing = mean_spacing(set.points);
    check_searches(set.points, {0.6 * spacing, 2 * spacing});
  }
}

TEST_SUITE_END();
