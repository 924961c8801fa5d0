// What: the plane cut into regions in many ways, regions with their points, and what of the whole is expected.
// Law:  a function of the arguments alone. Borders run through points wherever they can.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rbpa/partial.h"
#include "support/random.h"
#include "support/triangle.h"

namespace rbpa_test {

using Regions = std::vector<rbpa::Region>;

/// Lines along both axes, up to so many each way.
Regions grid_cut(const Points& points, std::size_t lines, Random& random);
/// Regions that are halved again and again, so many times.
Regions halving_cut(const Points& points, std::size_t cuts, Random& random);
/// Squares that are quartered while they have more than so many points.
Regions quartering_cut(const Points& points, std::size_t most);
/// One of these.
Regions any_cut(const Points& points, std::size_t regions, Random& random);

/// Points of a region and its halo, with their indices; in another order when `shuffled`.
struct Given {
  Points points;
  std::vector<std::uint64_t> indices;
  operator rbpa::RegionPoints() const { return {points, indices}; }
};
Given given(const rbpa::Region& region, const Points& points, double alpha, Random* shuffled = nullptr);

/// Each region by itself.
std::vector<rbpa::Partial> partials(const Regions& regions, const Points& points, double alpha);

/// All of them merged, two by two in any order; every now and then one goes through bytes.
rbpa::Partial merged(std::vector<rbpa::Partial> parts, Random& random);

/// By rbpa(), count() and polygons() of all points.
rbpa::WholeComplex whole(const Points& points, double alpha);

/// Empty when both are the same to the last bit; else what is not.
std::string difference(const rbpa::WholeComplex& found, const rbpa::WholeComplex& expected);

}  // namespace rbpa_test
