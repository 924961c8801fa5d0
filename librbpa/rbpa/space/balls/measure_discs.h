// What:   computes area and boundary of a union of discs in the plane, the part of each disc in them, and the boundary
//         as closed curves of arcs.
// How:    discs are balls with their centers in a plane: their regular triangulation and dual complex decide which
//         discs meet, which arcs are on the boundary, and which curves bound holes. docs/explanation/space.md, section
//         26.
// Law:    every decision is exact; a function of the set of discs, up to numbering. Angles and sizes are rounded:
//         errors are some 10⁻¹⁴ of the size of a disc (measured). Totals are exact sums, rounded once.
// Cost:   that of a regular triangulation, and about linear.
// Source: Edelsbrunner, The union of balls and its dual shape (1995).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/polygon.h"
#include "rbpa/base/progress.h"

namespace rbpa {

/// An arc of the circle around a disc, passed counter-clockwise. Angles are in radians from the direction of x.
struct DiscArc {
  std::uint32_t disc;
  double begin = 0;  ///< from −π to π
  double angle = 0;  ///< angle of the arc, from 0 to 2π
};

/// A closed curve of the boundary, with the union on its left: an outer curve is passed counter-clockwise, the curve of
/// a hole clockwise. Each arc ends where the next one begins.
struct DiscCurve {
  std::vector<DiscArc> arcs;
  std::uint32_t component = 0;  ///< number of the component of the union
  bool is_hole = false;
  double area = 0;    ///< area that the curve encloses, negative for a hole
  double length = 0;  ///< sum of the lengths of the arcs
};

/// Sizes of a union of discs. Lengths are in the unit of the coordinates.
struct DiscMeasures {
  double area = 0, length = 0;  ///< of the whole union; length: that of its boundary
  /// For each disc: the area of the part of the union within its power cell, and the length of its circle on the
  /// boundary, which is exactly 0 for a covered circle.
  std::vector<double> areas, lengths;
  /// The value of `components` for a disc that has no part of the union.
  static constexpr std::uint32_t none = 0xffffffff;
  /// For each disc: the number of its component of the union. Components are numbered by the lowest index of their
  /// discs. Discs that only touch are in different components.
  std::vector<std::uint32_t> components;
  /// The discs that have no part of the union: discs inside others, discs equal to one of lower index, and discs that
  /// do not meet their power cells. Ascending.
  std::vector<std::uint32_t> hidden;
  /// The boundary, component by component: the outer curve, then the curves of its holes.
  std::vector<DiscCurve> boundary;
};

struct MeasureDiscsOptions {
  MaxThreads threads = 0;
  OnProgress progress = {};  ///< Progress::triangles is the number of triangulated discs, then 0
};

/// Measures discs at any position. Discs may be nested, equal, or of radius 0.
/// Requires: what regular_triangulation() requires of balls.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API DiscMeasures measure_discs(std::span<const Point> centers, std::span<const double> radii,
                                    const MeasureDiscsOptions& options = {});

/// Polygons with corners on the circles of discs.
struct DiscPolygons {
  std::vector<Point> points;              ///< all corners; rings have indices of these
  std::vector<Polygon> polygons;          ///< the components of the union in order
  std::vector<std::uint32_t> components;  ///< the number of the component of each polygon
};

/// Returns the components of a union of discs as polygons: a corner at the beginning of each arc, and corners within
/// the arc, equally spaced, at most an angle of 2π / `corners` apart. The polygons are parts of the union, and no two
/// of their edges cross, up to the rounding of corners: where circles nearly touch, or three of them nearly meet in a
/// point, corners may be equal. Holes and components whose corners are all within rounding of each other are left out.
/// Requires: `measures` is measure_discs() of these discs; corners ≥ 3; fewer than 2^32 corners in all.
/// Throws:   ContractViolation when this is visibly not so; Cancelled.
/// Cost:     linear in the corners, and a sort of the holes.
RBPA_API DiscPolygons disc_polygons(const DiscMeasures& measures, std::span<const Point> centers,
                                    std::span<const double> radii, unsigned corners, const GoOn& go_on = {});

}  // namespace rbpa
