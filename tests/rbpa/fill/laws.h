// What: what must be true of polygons that were filled.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rbpa/fill.h"
#include "support/triangle.h"

namespace rbpa_test {

/// The first thing that is wrong with a filling, "" when nothing is:
///   a triangle is not counter-clockwise, or out of order; arrays or mesh are not sound, or not the same; a side
///   without a neighbor is not an edge of a ring, as it runs, or an edge of a ring no such side; the areas of triangles
///   and rings do not add up to the same, exactly; points of the input have moved, or others are in no triangle; a ring
///   does not pass the points of the input in their order, or others are farther from its edges than rounding.
/// Why that is enough: sides of positive triangles that add up to the boundary of the polygons cover every place inside
/// once, and no other.
std::string wrong_with_filling(const rbpa::Filling& filling, std::span<const rbpa::Point> points,
                               std::span<const rbpa::Polygon> polygons, bool keeps_boundary);

/// The same of groups that may share edges and overlap: each by itself is filled as above; what lies beyond the edges
/// of one is the one triangle of another there, where neither overlaps others, and nothing else.
std::string wrong_with_groups(const rbpa::Filling& filling, std::span<const rbpa::Point> points,
                              std::span<const rbpa::Polygon> polygons, std::span<const std::size_t> groups,
                              bool keeps_boundary);

/// How good triangles are.
struct FillQuality {
  std::size_t edges = 0, edges_in_range = 0;  ///< from 0.6 to 1.6 of the target in their middle
  std::size_t triangles = 0, with_20_degrees = 0;
};

/// Triangles within 2 sizes of a corner of the input sharper than 60 degrees are not counted.
FillQuality quality_of(const rbpa::Filling& filling, const rbpa::FillOptions& options,
                       std::span<const rbpa::Point> points, std::span<const rbpa::Polygon> polygons);

/// The size that options prescribe, from their definition: also of the boundary's own edges, those of the rings given.
double wanted_size(const rbpa::Point& p, const rbpa::FillOptions& options, std::span<const rbpa::Point> points,
                   std::span<const rbpa::Polygon> polygons);

}  // namespace rbpa_test
