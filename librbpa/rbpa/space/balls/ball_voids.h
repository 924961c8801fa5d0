// What:   finds the voids of a union of balls with different radii, and its pockets with their mouths: volume, area,
//         the balls that line them, and the largest ball that fits in.
// How:    voids are components of the tetrahedra outside of the dual complex, not connected to the outside. For
//         pockets, the outside has the tetrahedra that flow to infinity, each across triangles to its orthocenter.
//         docs/explanation/space.md, section 25.
// Law:    tetrahedra and triangles are exact; a function of the set of balls. An orthocenter in the plane of a face
//         is not beyond it. Sizes are rounded, as those of measure_balls().
// Cost:   linear in the tetrahedra; for each void also some triangulations of the balls around it.
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

struct BallVoidsOptions {
  bool pockets = false;  ///< whether BallVoids::pockets are found
  MaxThreads threads = 0;
  OnProgress progress = {};  ///< Progress::triangles is 0
};

/// A ball at a void or pocket, and the area of its sphere that faces the void.
struct LiningBall {
  std::uint32_t ball;
  double area;
};

/// A mouth of a pocket: triangles to the outside, connected through edges that are not in the dual complex.
struct BallMouth {
  std::vector<Triangle> triangles;   ///< corners counter-clockwise seen from outside; the lowest first; ascending
  std::vector<std::uint32_t> balls;  ///< corners of these triangles that are in the dual complex; ascending
  double area_of_triangles = 0;
  double area = 0;       ///< area of the triangles outside of the balls
  double perimeter = 0;  ///< length of the border of `area` at balls, also at balls that it surrounds
  /// The mouth is closed in the union of balls with the squared radii R² + power. With equal radii these balls are the
  /// least ones that separate the pocket from the outside here.
  double power = 0;
  /// The largest ball around `center` that meets none of the balls at corners of the pocket. `center` is the center of
  /// the circle that touches the three balls of the triangle that closes last.
  Point3 center;
  double radius = 0;
};

/// A void or pocket of a union of balls.
struct BallVoid {
  std::vector<std::uint32_t> tetrahedra;  ///< positions in RegularTriangulation::simplices, ascending
  double volume_of_tetrahedra = 0;
  /// Volume outside of the balls, and area of their spheres there. The part of a ball that reaches through a mouth is
  /// counted with the tetrahedra at its center, so both may be below 0 for a shallow pocket.
  double volume = 0, area = 0;
  std::vector<LiningBall> balls;  ///< corners that are in the dual complex; ascending
  /// The largest ball that meets none of the balls at corners of the tetrahedra. In a void it is the largest one of all
  /// that fit in. In a pocket, no small move of its center makes it larger, or the center is an orthocenter.
  Point3 center;
  double radius = 0;  ///< 0, with the center at the origin, if rounding leaves no room
  double power = 0;   ///< the least power p such that balls with the squared radii R² + p fill the void or pocket
  std::vector<BallMouth> mouths;  ///< none for a void; by descending power, then by coordinates
};

/// The voids, and the pockets that have mouths, each by descending volume_of_tetrahedra, then by coordinates.
struct BallVoids {
  std::vector<BallVoid> voids, pockets;
  double volume = 0, area = 0;  ///< sums over the voids, without pockets
};

/// Finds the voids of balls whose triangulation is already computed. There are none if all centers are in a plane. The
/// voids for the center of a probe are those of balls whose radii include the radius of the probe.
/// Requires: `regular` is regular_triangulation() of these balls, with neighbors.
/// Throws:   ContractViolation unless there is one radius for each center, if neighbors are missing, or a corner does
///           not exist; Cancelled.
RBPA_API BallVoids ball_voids(std::span<const Point3> centers, std::span<const double> radii,
                              const RegularTriangulation& regular, const BallVoidsOptions& options = {});

/// Returns the triangles between the tetrahedra of a void or pocket and all others or the outside, in the order of the
/// tetrahedra, with their corners counter-clockwise seen from outside of the void.
/// Requires: the void is one of ball_voids() with `regular`; this is not checked.
RBPA_API std::vector<Triangle> boundary_of(const BallVoid& hollow, const RegularTriangulation& regular);

}  // namespace rbpa
