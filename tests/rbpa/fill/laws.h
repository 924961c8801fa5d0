// What: the laws that filled polygons obey.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rbpa/fill.h"
#include "support/triangle.h"

namespace rbpa_test {

/// Returns the first violated law of a filling, "" when there is none. Laws:
///   triangles are counter-clockwise and in canonical order; arrays and mesh are sound, and agree; the sides without a
///   neighbor are exactly the edges of the rings, in their direction; the areas of triangles and of rings have exactly
///   the same sum; points of the input have not moved, and all other points are in triangles; a ring passes the points
///   of the input in their order, and its other points are no farther from its edges than rounding.
/// These laws suffice: sides of positive triangles that sum up to the boundary of the polygons cover every place inside
/// exactly once, and no other place.
std::string wrong_with_filling(const rbpa::Filling& filling, std::span<const rbpa::Point> points,
                               std::span<const rbpa::Polygon> polygons, bool keeps_boundary);

/// Returns the first violated law of groups that may share edges and overlap. Each group by itself is filled as above.
/// Beyond an edge of one group lies exactly the one triangle of another group there, where neither overlaps other
/// groups.
std::string wrong_with_groups(const rbpa::Filling& filling, std::span<const rbpa::Point> points,
                              std::span<const rbpa::Polygon> polygons, std::span<const std::size_t> groups,
                              bool keeps_boundary);

/// The quality of the triangles of a filling.
struct FillQuality {
  std::size_t edges = 0, edges_in_range = 0;  ///< from 0.6 to 1.6 of the target in their middle
  std::size_t triangles = 0, with_20_degrees = 0;
};

/// Measures the quality. Triangles within 2 sizes of a corner of the input sharper than 60 degrees are not counted.
FillQuality quality_of(const rbpa::Filling& filling, const rbpa::FillOptions& options,
                       std::span<const rbpa::Point> points, std::span<const rbpa::Polygon> polygons);

/// Returns the size that options prescribe, from their definition, including the boundary's own edges, those of the
/// given rings.
double wanted_size(const rbpa::Point& p, const rbpa::FillOptions& options, std::span<const rbpa::Point> points,
                   std::span<const rbpa::Polygon> polygons);

}  // namespace rbpa_test
