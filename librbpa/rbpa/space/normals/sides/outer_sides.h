// What:   finds the outer side of points on closed surfaces, by the Delaunay tetrahedra inside and outside of them. The
//         tree of orient_normals() errs where two sheets are nearly as near to each other as the points are.
// How:    neighboring tetrahedra whose circumspheres nearly agree are on one side of the surface; the two poles of a
//         point, the farthest centers of its tetrahedra in opposite directions, are on different sides. A system of
//         linear equations weighs all this, from the outside of the hull (docs/explanation/surfaces.md, section 19).
// Law:    a function of the neighborhoods. An estimate: a component, connected through nearest points, is left to the
//         tree if the poles of too many points contradict, or if large facets are needed to close the surface. So are
//         points on curves.
// Cost:   that of solid(), and about as much again; all but solid() in one thread.
// Source: Amenta, Choi, Kolluri, The power crust (2001); Kolluri, Shewchuk, O'Brien, Spectral surface reconstruction
//         from noisy point clouds (2004); Kunegis et al., Spectral analysis of signed graphs (2010).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/surface/neighbors/find_nearest.h"

namespace rbpa::space {

/// The outer side of each point. The lists are empty if no side is known.
struct OuterSides {
  std::vector<std::int8_t> side;  ///< for each point: 1 if its normal points outward, −1 if inward, 0 if not known
  std::vector<double> vote;  ///< for each point, the share from 0 to 1 of what surrounds it that agrees; 0 if not known

  bool empty() const { return side.empty(); }  ///< whether the lists are empty: no side is known
};

/// Returns the outer sides. Replaces a normal that lies nearly in the surface between inside and outside, as that of a
/// plane fitted to both sides of a thin wall may, by the mean outward normal of that surface around the point.
/// Requires: unit normals, in the order of the neighborhoods; points that fit_double() has scaled. Throws: Cancelled.
OuterSides outer_sides(const Neighborhoods& near, std::span<Point3> normals, const SolidOptions& options);

}  // namespace rbpa::space
