// What: point sets of space of every kind that decides differently, and radii at which they do.
// Law:  a function of the arguments alone, down to the last bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "rbpa/base/point3.h"
#include "support/random.h"

namespace rbpa_test {

using Points3 = std::vector<rbpa::Point3>;

enum class SpaceKind {
  cube,          ///< anywhere in a cube
  grid,          ///< on a small integer grid, with repetitions: ties of every kind
  cospherical,   ///< integer points of one sphere, and its center
  near_sphere,   ///< of the unit sphere, rounded
  plane,         ///< on a plane through no axis, exactly
  plane_grid,    ///< on an integer grid in an axis plane
  line,          ///< on a line, exactly
  line_and_few,  ///< that, and some beside it
  plate,         ///< two sheets nearer to each other than the points on them
  noisy_sphere,  ///< of a sphere, with noise
  clusters,      ///< of sizes that differ by powers of ten
  nearest,       ///< pairs that differ in last bits
  extreme,       ///< small sets at 1e150, at 1e-150, and both
};
inline constexpr int space_kinds = static_cast<int>(SpaceKind::extreme) + 1;

std::string name(SpaceKind kind);

/// About `count` points.
Points3 space_set(SpaceKind kind, std::size_t count, Random& random);

/// A radius that decides something: half of a distance, the circumradius of three or four of the points, rounded; or a tie
/// of integers; or one anywhere between below the spacing and all of the set.
double space_radius(const Points3& points, Random& random);

/// Vectors of any direction and length but 0.
Points3 random_normals(std::size_t count, Random& random);

}  // namespace rbpa_test
