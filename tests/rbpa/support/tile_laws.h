// What: what tiles must find, by whatever finder.
// Law:  each check names the first law that is broken, or returns "".
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rbpa/plane/grid/point_grid.h"
#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/tile/tile_patch.h"
#include "support/triangle.h"

namespace rbpa_test {

/// The Delaunay triangles of the sites of a grid, once for many radii.
struct SiteSet {
  explicit SiteSet(const Points& input);
  rbpa::PointGrid grid;
  Points points;
  std::vector<Triangle> delaunay;

  std::vector<Triangle> within(const rbpa::Radius& radius) const;
};

/// The patch of each tile.
std::vector<rbpa::TilePatch> patches_of(const rbpa::PointGrid& grid, const rbpa::Radius& radius,
                                        std::uint32_t max_points);

/// Its outline is the one that is surveyed.
bool is_outlined(const rbpa::TilePatch& tile);

bool same(const rbpa::TilePatch& a, const rbpa::TilePatch& b);

/// Triangles are of the complex and found once, sides and outlines are right, and nothing is missing at settled sites.
std::string wrong_with(const std::vector<rbpa::TilePatch>& patches, const std::vector<Triangle>& complex);

/// The same of every vector unit that this processor has, and that all find the same.
std::string wrong_on(const Points& input, std::uint32_t max_points,
                     const std::function<std::vector<rbpa::Radius>(const SiteSet&)>& radii);

}  // namespace rbpa_test
