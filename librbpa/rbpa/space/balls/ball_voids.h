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

/// A ball at a void, and the area of its sphere that faces the void.
struct LiningBall {
  std::uint32_t ball;
  double area;
};

/// Triangles between a pocket and the outside, connected through edges outside of the dual complex.
struct BallMouth {
  std::vector<Triangle> triangles;   ///< corners counter-clockwise seen from outside; the lowest first; ascending
  std::vector<std::uint32_t> balls;  ///< corners of these triangles that are in the dual complex; ascending
  double area_of_triangles = 0;
  double area = 0;       ///< of these triangles, outside of the balls
  double perimeter = 0;  ///< length of the border between this area and the balls, also of balls within
  /// The mouth is closed in the union of balls with the squared radii R² + power. With equal radii these balls are the
  /// least ones that separate the pocket from the outside here.
  double power = 0;
  /// The largest ball around this center that meets none of the balls at corners of the pocket. The center is that of
  /// the circle that touches the three balls of the triangle that closes last.
  Point3 center;
  double radius = 0;
};

/// A void or pocket of a union of balls.
struct BallVoid {
  std::vector<std::uint32_t> tetrahedra;  ///< indices, ascending
  double volume_of_tetrahedra = 0;
  /// Volume outside of the balls, and area of their spheres there. The part of a ball that reaches through a mouth is
  /// counted with the tetrahedra at its center.
  double volume = 0, area = 0;
  std::vector<LiningBall> balls;  ///< corners that are in the dual complex; ascending
  /// The largest ball that meets none of the balls at corners of the tetrahedra. In a void it is the largest one of all
  /// that fit in. In a pocket its center is where no small move makes it larger, or an orthocenter.
  Point3 center;
  double radius = 0;
  double power = 0;  ///< the union of balls with the squared radii R² + power fills it: the greatest power
  std::vector<BallMouth> mouths;  ///< none for a void; by descending power, then by coordinates
};

/// The voids, and the pockets that have mouths. By descending volume_of_tetrahedra, then by coordinates.
struct BallVoids {
  std::vector<BallVoid> voids, pockets;
  double volume = 0, area = 0;  ///< of all voids: outside of the balls, and of their spheres
};

/// Finds the voids of balls whose triangulation is already computed. There are none if all centers are in a plane.
/// Radii include a probe: grown by it, the balls leave what the center of the probe can reach.
/// Requires: `regular` is regular_triangulation() of these balls, with neighbors.
/// Throws:   ContractViolation where radii or neighbors are missing, or a corner does not exist; Cancelled.
RBPA_API BallVoids ball_voids(std::span<const Point3> centers, std::span<const double> radii,
                              const RegularTriangulation& regular, const BallVoidsOptions& options = {});

}  // namespace rbpa
