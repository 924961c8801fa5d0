// What: generates points in boxes that repeat, and computes their tetrahedra by the definition.
// Law:  a set is a function of its arguments.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rbpa/space/solid/periodic_solid.h"
#include "support/random.h"
#include "support/space_sets.h"

namespace rbpa_test {

struct PeriodicSet {
  std::string name;
  Points3 points;
  rbpa::Point3 box;
};

/// Returns about `count` points, of one kind in turn: uniform, on integer and body-centered lattices with vacancies, in
/// layers and rods, near the sides of the box, outside of it, with duplicates.
PeriodicSet periodic_set(std::uint64_t kind, std::size_t count, Random& random);
inline constexpr std::uint64_t periodic_kinds = 9;

/// Corners in the order of a row of the result.
using PeriodicCorners = std::array<rbpa::PeriodicVertex, 4>;

std::vector<PeriodicCorners> rows_of(const rbpa::PeriodicSolid& solid);

/// Positions of 27 images of each point in the box, in the order of vertices.
struct AllImages {
  std::vector<rbpa::PeriodicVertex> vertices;
  Points3 positions;
};
AllImages all_images(const Points3& in_box, const rbpa::Point3& box);

/// Returns the points modulo the box, rounded, by the definition. `box` has the rounded sides.
Points3 wrapped(const PeriodicSet& set, const rbpa::Point3& box);

}  // namespace rbpa_test
