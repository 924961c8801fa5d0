// What: the triangles that tiles must find, with any finder.
// Law:  each check returns the first violated law, or "".
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

/// The Delaunay triangles of the sites of a grid, computed once for many radii.
struct SiteSet {
  explicit SiteSet(const Points& input);
  rbpa::PointGrid grid;
  Points points;
  std::vector<Triangle> delaunay;

  std::vector<Triangle> within(const rbpa::Radius& radius) const;
};

/// Returns the patch of each tile.
std::vector<rbpa::TilePatch> patches_of(const rbpa::PointGrid& grid, const rbpa::Radius& radius,
                                        std::uint32_t max_points);

/// Returns whether the outline of the patch equals a newly surveyed one.
bool is_outlined(const rbpa::TilePatch& tile);

bool same(const rbpa::TilePatch& a, const rbpa::TilePatch& b);

/// Checks that triangles are of the complex and found once, sides and outlines are right, and none is missing at
/// settled sites.
std::string wrong_with(const std::vector<rbpa::TilePatch>& patches, const std::vector<Triangle>& complex);

/// Checks every vector unit of this processor, and that all of them find the same.
std::string wrong_on(const Points& input, std::uint32_t max_points,
                     const std::function<std::vector<rbpa::Radius>(const SiteSet&)>& radii);

}  // namespace rbpa_test
