// What:   finds the voids of a union of balls with different radii, and its pockets with their mouths: volume, area,
//         the balls that line them, and the largest ball that fits in.
// How:    a void is a component of the tetrahedra outside of the dual complex that is not connected to the outside. For
//         pockets, only tetrahedra that flow to infinity belong to the outside: each flows across the triangles that
//         separate it from its orthocenter. docs/explanation/space.md, section 25.
// Law:    the choice of tetrahedra and triangles is exact, and a function of the set of balls. An orthocenter in the
//         plane of a face is not beyond the face. Sizes are rounded like those of measure_balls().
// Cost:   about linear in the tetrahedra; for each void or pocket also some triangulations of the balls around it.
// Source: Edelsbrunner, Facello, Fu, Liang, Measuring proteins and voids in proteins (1995); Edelsbrunner, Facello,
//         Liang, On the definition and the construction of pockets in macromolecules (1998).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/balls/regular_triangulation.h"

namespace rbpa {

/// Options of ball_voids().
struct BallVoidsOptions {
  bool pockets = false;  ///< whether BallVoids::pockets are found
  MaxThreads threads = 0;
  OnProgress progress = {};  ///< Progress::triangles is 0
};

/// A ball at a void or pocket, and the area of its sphere that faces the void or pocket.
struct LiningBall {
  std::uint32_t ball;  ///< input index, of equal balls the lowest
  double area;
};

/// A mouth of a pocket: triangles to the outside, connected through edges that are not in the dual complex.
struct BallMouth {
  std::vector<Triangle> triangles;   ///< corners counter-clockwise seen from outside; the lowest first; ascending
  std::vector<std::uint32_t> balls;  ///< corners of these triangles that are in the dual complex; ascending
  double area_of_triangles = 0;
  double area = 0;       ///< area of the triangles outside of the balls
  double perimeter = 0;  ///< length of the border of `area` at balls, also at balls that it surrounds
  /// The mouth is closed in the union of balls with the squared radii R² + power. If all radii are equal, no smaller
  /// equal balls close the mouth.
  double power = 0;
  /// The largest ball around `center` that meets none of the balls at corners of the pocket. `center` is the center of
  /// the circle that touches the three balls at the triangle of the mouth that closes last. If that triangle closes
  /// together with the tetrahedron outside of it, the ball that touches the four balls there gives the center. If there
  /// is no touching circle or ball, `center` is the orthocenter.
  Point3 center;
  double radius = 0;
};

/// A void or pocket of a union of balls.
struct BallVoid {
  /// Positions in RegularTriangulation::simplices, ascending; empty in a cell that repeats.
  std::vector<std::uint32_t> tetrahedra;
  double volume_of_tetrahedra = 0;
  /// Volume outside of the balls, and area of their spheres there. The part of a ball that reaches through a mouth is
  /// counted with the tetrahedra at the ball's center, so both sizes may be below 0 for a shallow pocket.
  double volume = 0, area = 0;
  std::vector<LiningBall> balls;  ///< balls at the corners that are in the dual complex; ascending
  /// The largest ball that meets none of the balls at corners of the tetrahedra. In a void no larger ball fits. In a
  /// pocket, no small move of the center makes the ball larger, or the center is an orthocenter.
  Point3 center;
  double radius = 0;  ///< 0, with the center at the origin, if rounding leaves no room
  double power = 0;   ///< the least power p such that balls with the squared radii R² + p fill the void or pocket
  std::vector<BallMouth> mouths;  ///< none for a void; by descending power, then by coordinates
  /// In a cell that repeats, the number of independent directions in which it percolates: 0 = closed, 1 = channel, 2 =
  /// layer, 3 = network. Otherwise 0.
  unsigned dimension = 0;
};

/// The voids, and the pockets that have mouths, each by descending volume_of_tetrahedra, then by coordinates. Lengths
/// are in the unit of the coordinates.
struct BallVoids {
  std::vector<BallVoid> voids, pockets;
  double volume = 0, area = 0;  ///< sums over the voids, without pockets
};

/// Finds the voids, and on request the pockets, of balls whose triangulation is already computed. There are none if all
/// centers are in a plane. To find the voids in which the center of a probe fits, add the radius of the probe to all
/// radii.
/// Requires: `regular` is regular_triangulation() of these balls, with neighbors.
/// Throws:   ContractViolation unless there is one radius for each center, if neighbors are missing, or a corner does
///           not exist; Cancelled.
RBPA_API BallVoids ball_voids(std::span<const Point3> centers, std::span<const double> radii,
                              const RegularTriangulation& regular, const BallVoidsOptions& options = {});

/// Returns the triangles between the tetrahedra of a void or pocket and all other tetrahedra or the outside, in the
/// order of the void's tetrahedra. Corners are counter-clockwise seen from outside of the void.
/// Requires: the void is one of ball_voids() with `regular`; this is not checked.
/// Cost:     n log n for n tetrahedra of the void.
RBPA_API std::vector<Triangle> boundary_of(const BallVoid& hollow, const RegularTriangulation& regular);

}  // namespace rbpa
