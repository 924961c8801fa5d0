#include "support/tile_laws.h"

#include <hwy/targets.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "meshops/patch/outline.h"
#include "meshops/patch/patch.h"
#include "rbpa/plane/patches/find_patch.h"
#include "rbpa/plane/tile/cut.h"
#include "support/one_target.h"
#include "support/shrink.h"
#include "support/tile_sets.h"

namespace rbpa_test {

using meshops::Patch;
using rbpa::Radius;
using rbpa::TilePatch;

namespace {

/// Describes the sizes of two patches.
std::string unlike(const TilePatch& a, const TilePatch& b) {
  return "triangles " + std::to_string(a.patch.triangles.size()) + " and " + std::to_string(b.patch.triangles.size()) +
         ", known " + std::to_string(a.settled.size()) + " and " + std::to_string(b.settled.size());
}

Triangle corners(const std::array<meshops::Site, 3>& t) {
  return canonical(
      {{static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])}})[0];
}

}  // namespace

bool is_outlined(const TilePatch& tile) {
  meshops::Outline expected;
  survey(tile.patch, expected);
  std::vector<int> inside = tile.outline.inside;
  for (auto* sides : {&inside, &expected.inside}) std::sort(sides->begin(), sides->end());
  return tile.outline.rim == expected.rim && tile.outline.holes == expected.holes &&
         tile.outline.next_hole == expected.next_hole && inside == expected.inside;
}

SiteSet::SiteSet(const Points& input)
    : grid(input), points(grid.points().begin(), grid.points().end()), delaunay(delaunay_by_winners(points)) {}

std::vector<Triangle> SiteSet::within(const Radius& radius) const {
  std::vector<Triangle> found;
  for (const Triangle& t : delaunay)
    if (radius.admits<double>(points[t[0]], points[t[1]], points[t[2]])) found.push_back(t);
  return found;
}

std::vector<TilePatch> patches_of(const rbpa::PointGrid& grid, const Radius& radius, std::uint32_t max_points) {
  std::vector<TilePatch> patches;
  rbpa::Cutter cutter(grid);
  rbpa::Tile tile;
  rbpa::FinderWorkspace workspace;
  for (const rbpa::Block& block : rbpa::blocks(grid, max_points)) {
    cutter.cut(block, tile);
    find_patch(tile, radius, workspace, patches.emplace_back());
  }
  return patches;
}

bool same(const TilePatch& a, const TilePatch& b) {
  return a.patch.triangles == b.patch.triangles && a.patch.across == b.patch.across && a.settled == b.settled;
}

std::string wrong_with(const std::vector<TilePatch>& patches, const std::vector<Triangle>& complex) {
  const std::set<Triangle> expected(complex.begin(), complex.end());
  std::map<std::pair<std::uint32_t, std::uint32_t>, Triangle> at_side;
  std::map<std::uint32_t, std::vector<Triangle>> at;
  for (const Triangle& t : complex)
    for (std::size_t i = 0; i < 3; ++i) {
      at_side[{t[i], t[(i + 1) % 3]}] = t;
      at[t[i]].push_back(t);
    }
  std::set<Triangle> found;
  std::set<std::uint32_t> known;
  for (const TilePatch& tile : patches) {
    const Patch& patch = tile.patch;
    if (patch.across.size() != patch.triangles.size()) return "sizes of a patch";
    if (!is_outlined(tile)) return "the outline of a patch is that of another one";
    std::set<Triangle> of_tile;
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
      const Triangle triangle = corners(patch.triangles[t]);
      const std::string name = "triangle " + std::to_string(triangle[0]) + " " + std::to_string(triangle[1]) + " " +
                               std::to_string(triangle[2]);
      if (!expected.contains(triangle)) return name + " is not of the complex";
      if (!found.insert(triangle).second) return name + " is found twice";
      of_tile.insert(triangle);
    }
    for (std::size_t t = 0; t < patch.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto from = static_cast<std::uint32_t>(patch.triangles[t][i]),
                   to = static_cast<std::uint32_t>(patch.triangles[t][(i + 1) % 3]);
        const std::string name = "side " + std::to_string(from) + " " + std::to_string(to);
        const auto beyond = at_side.find({to, from});
        const int across = patch.across[t][i];
        if (across == Patch::open || across == Patch::nothing) {
          if (beyond == at_side.end()) continue;
          if (across == Patch::nothing) return name + " has nothing beyond, and there is a triangle";
          if (of_tile.contains(beyond->second)) return name + " is open, and what is beyond is in the patch";
          continue;
        }
        const auto s = static_cast<std::size_t>(across);
        if (across < 0 || s >= 3 * patch.triangles.size()) return name + " is across of nothing";
        if (patch.across[s / 3][s % 3] != static_cast<int>(3 * t + i)) return name + " is not across of what is";
        if (static_cast<std::uint32_t>(patch.triangles[s / 3][s % 3]) != to ||
            static_cast<std::uint32_t>(patch.triangles[s / 3][(s % 3 + 1) % 3]) != from)
          return name + " is across of another edge";
      }
    for (const std::uint32_t s : tile.settled) {
      if (!known.insert(s).second) return "site " + std::to_string(s) + " is known twice";
      for (const Triangle& t : at[s])
        if (!of_tile.contains(t)) return "site " + std::to_string(s) + " is known, and a triangle at it is missing";
    }
  }
  return "";
}

std::string wrong_on(const Points& input, std::uint32_t max_points,
                     const std::function<std::vector<Radius>(const SiteSet&)>& radii) {
  const SiteSet sites(input);
  for (const Radius& r : radii(sites)) {
    const std::vector<Triangle> complex = sites.within(r);
    std::vector<TilePatch> first;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      const OneTarget only(target);
      const std::string at = std::string(" by ") + hwy::TargetName(target) + ", radius " +
                             (r.is_infinite() ? "infinity" : literal(r.value()));
      const auto patches = patches_of(sites.grid, r, max_points);
      if (const std::string wrong = wrong_with(patches, complex); !wrong.empty()) return wrong + at;
      if (first.empty()) first = patches;
      for (std::size_t i = 0; i < patches.size(); ++i)
        if (!same(first[i], patches[i])) return "another target finds others: " + unlike(first[i], patches[i]) + at;
    }
  }
  return "";
}

}  // namespace rbpa_test
