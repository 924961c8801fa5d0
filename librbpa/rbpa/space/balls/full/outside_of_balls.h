// What: measures the part of regions of tetrahedra outside of balls with different radii, and the share of each ball in
//       the surface there.
// How:  subtracts from the volume of the tetrahedra the parts of balls at their corners: docs/explanation/space.md,
//       section 25.
// Law:  the sizes of voids are right, up to rounding. If a ball reaches across a triangle outside of the complex, the
//       part beyond counts on the side of the tetrahedra at the ball's center.
// Cost: linear in the tetrahedra around the corners of regions.
// Source: Edelsbrunner, Facello, Fu, Liang, Measuring proteins and voids in proteins (1995).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/balls/full/edges.h"
#include "rbpa/space/balls/full/triangulated.h"

namespace rbpa::space {

/// Balls around the vertices of a triangulation, and regions of its tetrahedra outside of the balls' complex. The
/// functions are called from any thread.
struct BallRegions {
  static constexpr std::uint32_t none = 0xffffffff;

  Triangulated cells;
  std::span<const Point3> positions;      ///< positions of `cells`, in the scale of the radii
  std::span<const double> radii;          ///< for each vertex
  std::span<const std::uint32_t> region;  ///< for each tetrahedron, its region, or none
  std::size_t count = 0;                  ///< number of regions
  /// Return whether these are in the complex: the triangle across from corner k of t, the edge with these tetrahedra
  /// around it, and a point. If `has_vertex` is empty, all points are.
  std::function<bool(std::uint32_t t, std::size_t k)> is_wall;
  std::function<bool(std::span<const EdgeAt>)> has_edge;
  std::function<bool(std::uint32_t)> has_vertex = {};
};

/// Sizes of a region, in units of the scaled positions.
struct RegionMeasure {
  double tetrahedra = 0;  ///< volume of its tetrahedra, whatever the order of points
  double volume = 0;      ///< volume outside of the balls
  double area = 0;        ///< area of the balls' surface there
};

/// The part of a ball at a region.
struct RegionShare {
  std::uint32_t region, ball;
  double area;    ///< area of the sphere that is in the region and outside of the other balls
  double volume;  ///< what the ball takes from the volume of the tetrahedra; may be below 0
};

struct RegionMeasures {
  std::vector<RegionMeasure> all;
  std::vector<RegionShare> shares;  ///< of balls in the complex; ascending by region and ball
};

/// Measures the regions. Requires: positions and radii whose sixth powers fit double; a neighbor of a tetrahedron is
/// missing only across a wall or the hull. Throws: Cancelled.
RegionMeasures outside_of_balls(const BallRegions& regions, Threads& threads, const GoOn& go_on = {});

/// Returns for each of `voids` voids the volume of its part that is at least alpha from every point, in cubed units.
/// Requires: `space` has the tetrahedra of the voids, without a neighbor across a triangle of the complex; `void_of`
///           has for each tetrahedron the number of its void; 0 < alpha < infinity unless there are no tetrahedra.
/// Throws: Cancelled.
std::vector<double> outside_of_balls(const Triangulated& space, std::span<const std::uint32_t> void_of,
                                     std::size_t voids, double alpha, Threads& threads, const GoOn& go_on = {});

}  // namespace rbpa::space
