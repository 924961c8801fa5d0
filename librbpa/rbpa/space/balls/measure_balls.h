// What:   computes volume and surface area of a union of balls, the part of each ball in them, and the contacts of
//         balls.
// How:    the dual complex decides exactly which balls meet, and how they are connected. The area of a ball follows
//         from the angles of its arcs by the theorem of Gauss and Bonnet; its volume follows from its area and its
//         contacts by the divergence theorem. docs/explanation/space.md, section 24.
// Law:    the choice of simplices is exact. Angles and sizes are rounded: the error of an area is some 10⁻¹³ of the
//         sphere's, that of a volume some 10⁻¹³ of the ball's (measured). Totals are exact sums, rounded once.
// Cost:   that of a regular triangulation, and about linear in its tetrahedra.
// Source: Edelsbrunner, The union of balls and its dual shape (1995); Edelsbrunner, Koehl, The geometry of biomolecular
//         solvation (2005); Bryant, Edelsbrunner, Koehl, Levitt, The area derivative of a space-filling diagram (2004).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/balls/regular_triangulation.h"

namespace rbpa {

struct MeasureBallsOptions {
  double probe = 0;          ///< length that is added to each radius; the sums are rounded
  bool contacts = false;     ///< whether BallMeasures::contacts are filled in
  bool derivatives = false;  ///< whether BallMeasures has gradients
  MaxThreads threads = 0;
  OnProgress progress = {};  ///< Progress::triangles is the number of triangulated balls, then 0
};

/// The contact of two balls: the part of the disc within their common circle that is in the power cells of both balls.
/// A contact may have several pieces.
struct BallContact {
  std::array<std::uint32_t, 2> balls;  ///< ascending
  double area = 0;
  double arc = 0;       ///< length of the arcs of the circle that are on the surface of the union; 0 if none are
  double distance = 0;  ///< distance of the centers
};

/// Sizes of a union of balls. Lengths are in the unit of the coordinates.
struct BallMeasures {
  double volume = 0, area = 0;  ///< of the whole union
  /// For each ball: the volume of the part of the union within its power cell; and the area of its sphere on the
  /// surface of the union, which is exactly 0 for a buried ball.
  std::vector<double> volumes, areas;
  /// For each ball: the number of arcs of circles, whole circles included, that bound its area. The arcs are counted in
  /// the dual complex: an arc where spheres only touch has length 0.
  std::vector<std::uint32_t> arcs;
  /// The balls that have no part of the union: balls without a power cell, balls equal to one of lower index, and balls
  /// that do not meet their cells. Ascending.
  std::vector<std::uint32_t> hidden;
  std::vector<BallContact> contacts;  ///< all edges of the dual complex, ascending by balls; empty unless requested
  /// Derivatives of the union's volume and area by each center; empty unless requested.
  std::vector<Point3> volume_gradient, area_gradient;
};

/// Measures balls at any position. Balls may be nested, equal, or of radius 0.
/// Requires: finite centers, one radius for each; 0 ≤ radius + probe < infinity. If all centers are in one plane,
///           points farther away than all balls must still fit double.
/// Throws:   InvalidInput that names the violated requirement; what regular_triangulation() throws; Cancelled.
RBPA_API BallMeasures measure_balls(std::span<const Point3> centers, std::span<const double> radii,
                                    const MeasureBallsOptions& options = {});

/// Measures balls whose triangulation is already computed. The radii must include the probe: options.probe is ignored.
/// Requires: `regular` is regular_triangulation() of these balls, with neighbors, and has tetrahedra.
/// Throws:   ContractViolation when radii, tetrahedra or neighbors are missing; Cancelled. The rest is not checked.
RBPA_API BallMeasures measure_balls(std::span<const Point3> centers, std::span<const double> radii,
                                    const RegularTriangulation& regular, const MeasureBallsOptions& options = {});

}  // namespace rbpa
