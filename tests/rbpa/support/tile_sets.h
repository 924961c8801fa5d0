// What: point sets that are hard for tiles: crowds next to empty land, lattices and points just off one, ties.
// Law:  a function of the arguments alone; every set fits double.
#pragma once

#include <string>
#include <vector>

#include "support/random.h"
#include "support/triangle.h"

namespace rbpa_test {

struct TileSet {
  std::string name;
  Points points;
};

/// Returns sets of up to about 300 points each.
std::vector<TileSet> tile_sets();

/// Returns a set of up to a few dozen points, of any kind.
TileSet few_points(Random& random);

/// Returns points of a lattice of at most `columns` columns and rows, some of them moved by the smallest steps where
/// doubles are fine enough to distinguish them.
Points nearly_a_lattice(int columns, double kept, double moved, Random& random);

/// Returns integer points around one that is off them by so little that differences from it round to integers. That
/// point has a column of its own, or a row as well: no other point has a coordinate that distinguishes them.
Points lattice_around_a_stranger(Random& random);

/// Returns the Delaunay triangles, without ties because of the perturbation, in canonical order: for each edge, tests
/// all points as the apex. Requires: distinct points that fit double.
/// Cost: quadratic.
std::vector<Triangle> delaunay_by_winners(const Points& points);

}  // namespace rbpa_test
