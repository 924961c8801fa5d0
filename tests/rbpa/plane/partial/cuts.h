// What: the plane cut into regions in many ways, regions with their points, and the expected whole.
// Law:  a function of the arguments alone. Borders run through points wherever they can.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rbpa/plane/partial.h"
#include "support/random.h"
#include "support/triangle.h"

namespace rbpa_test {

using Regions = std::vector<rbpa::Region>;

/// Cuts along lines of both axes, up to `lines` of each.
Regions grid_cut(const Points& points, std::size_t lines, Random& random);
/// Halves regions repeatedly, `cuts` times.
Regions halving_cut(const Points& points, std::size_t cuts, Random& random);
/// Quarters squares while they have more than `most` points.
Regions quartering_cut(const Points& points, std::size_t most);
/// Cuts by grid_cut(), halving_cut() or quartering_cut().
Regions any_cut(const Points& points, std::size_t regions, Random& random);

/// Points of a region and its halo, with their indices; in random order when `shuffled`.
struct Given {
  Points points;
  std::vector<std::uint64_t> indices;
  operator rbpa::RegionPoints() const { return {points, indices}; }
};
Given given(const rbpa::Region& region, const Points& points, double alpha, Random* shuffled = nullptr);

/// Computes each region separately.
std::vector<rbpa::Partial> partials(const Regions& regions, const Points& points, double alpha);

/// Merges all of them, two by two in a random order; some pass through bytes.
rbpa::Partial merged(std::vector<rbpa::Partial> parts, Random& random);

/// Returns the whole complex by rbpa(), count() and polygons() of all points.
rbpa::WholeComplex whole(const Points& points, double alpha);

/// Returns the first difference; empty when both are the same to the last bit.
std::string difference(const rbpa::WholeComplex& found, const rbpa::WholeComplex& expected);

}  // namespace rbpa_test
