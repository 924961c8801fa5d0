// What:   finds the voids and channels of a union of balls in a cell that repeats, and in how many directions each
//         percolates; with sizes, the balls around, and the largest ball that fits in each.
// How:    tetrahedra of one cell outside of the dual complex are joined across triangles that are not in it; a part
//         that reaches an image of itself percolates. docs/explanation/space.md, section 28.
// Law:    edges and centers are rounded, relative to the cell by less than 2⁻⁴⁴. For the rounded ones the choice of
//         tetrahedra is exact, and a function of the set of balls. The volumes of all parts and of the union make up
//         the cell, up to rounding.
// Cost:   that of the regular triangulation of the balls and their images, at least four spacings around the cell, or
//         two diameters of the widest tetrahedron of a void; and of some triangulations around each void.
// Source: Edelsbrunner, Facello, Fu, Liang, Measuring proteins and voids in proteins (1995); Caroli, Teillaud, Delaunay
//         triangulations of closed Euclidean d-orbifolds (2016).
#pragma once

#include <span>

#include "rbpa/base/api.h"
#include "rbpa/space/balls/ball_voids.h"
#include "rbpa/space/balls/periodic_balls.h"

namespace rbpa {

/// Finds the voids of one cell. BallVoids::voids has one image of each closed void, and each part that percolates; the
/// sizes of such a part are those in one cell. There are no pockets. To find the voids in which the center of a probe
/// fits, add the radius of the probe to all radii.
/// Requires: what measure_periodic_balls() requires without a probe; a cell that repeats along all three edges.
/// Throws:   InvalidInput that names the violated requirement, or if the cell is so flat that too many images are
///           required; Cancelled.
RBPA_API BallVoids periodic_ball_voids(std::span<const Point3> centers, std::span<const double> radii,
                                       const RepeatingCell& cell, const SolidOptions& options = {});

}  // namespace rbpa
