// What: generates points in space of the shapes that matter for tetrahedra: volumes, surfaces, curves, grids, clusters,
//       extremes.
// Law:  a set is a function of its arguments.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "support/space_sets.h"

namespace rbpa_test {

struct SolidSet {
  std::string name;
  Points3 points;
  bool is_solid = true;  ///< the set has hundreds of tetrahedra
};

/// Returns one set of each shape, with about `count` points each.
std::vector<SolidSet> solid_sets(std::size_t count);

/// Uniform points in a cube whose side makes the mean spacing 1.
Points3 uniform_cube(std::size_t count, std::uint64_t seed);
/// One point in each cell of an integer grid, anywhere in the lower half of the cell: shuffled.
Points3 jittered_cubes(std::size_t count, std::uint64_t seed);
/// All points of an integer grid times the pitch, shuffled.
Points3 cubic_grid(std::size_t count, double pitch, std::uint64_t seed);
/// Integer grid times an integer matrix whose columns are orthogonal and equally long: ties as on a grid, and
/// coordinates of 25 bits.
Points3 turned_grid(std::size_t count, std::uint64_t seed);
/// Points of an integer grid up to seven wide, with a third of the coordinates moved by a power of ten from 1 to 1e-19:
/// nearly all decisions are ties, and lengths of edges that differ by more than the digits of double.
Points3 moved_lattice(std::size_t count, Random& random);
/// Clusters of a thousand points, of 1e-1 to 1e-9 of the distance between them.
Points3 clusters_in_cube(std::size_t count, std::uint64_t seed);
/// Points of the unit sphere, rounded.
Points3 on_unit_sphere(std::size_t count, std::uint64_t seed);
/// (t, t², t³), t from 0 to 1: every two points are joined.
Points3 moment_curve(std::size_t count);

}  // namespace rbpa_test
