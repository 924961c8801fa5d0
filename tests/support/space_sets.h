// What: generates point sets in space that reach every kind of decision, and radii at which they do.
// Law:  a set is a function of its arguments alone, down to the last bit.
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
  cube,          ///< random points of a cube
  grid,          ///< on a small integer grid, with repetitions: ties of every kind
  cospherical,   ///< integer points of one sphere, and its center
  near_sphere,   ///< points of the unit sphere, rounded
  plane,         ///< exactly on a plane that contains no axis
  plane_grid,    ///< on an integer grid in an axis plane
  line,          ///< exactly on a line
  line_and_few,  ///< points on a line, and some off it
  plate,         ///< two sheets nearer to each other than the points on them
  noisy_sphere,  ///< points of a sphere, with noise
  clusters,      ///< clusters whose sizes differ by powers of ten
  nearest,       ///< pairs of points that differ in the last bits
  extreme,       ///< small sets at 1e150, at 1e-150, and both
};
inline constexpr int space_kinds = static_cast<int>(SpaceKind::extreme) + 1;

std::string name(SpaceKind kind);

/// Returns about `count` points.
Points3 space_set(SpaceKind kind, std::size_t count, Random& random);

/// Returns a radius at which something is decided: half of a distance, or the circumradius of three or four of the
/// points, rounded; or a tie of integers; or any radius between less than the spacing and more than the extent of the
/// set.
double space_radius(const Points3& points, Random& random);

/// Returns the corners of bricks of this size in columns along x, rows along y and layers along z, in this order.
Points3 corners_of_bricks(int columns, int rows, int layers, const rbpa::Point3& size = {1, 1, 1});

/// Returns vectors of any direction and any length but 0.
Points3 random_normals(std::size_t count, Random& random);

}  // namespace rbpa_test
