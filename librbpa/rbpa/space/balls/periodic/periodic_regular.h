// What: computes the regular triangulation of the balls of a cell that repeats and all their images: the tetrahedra of
//       one cell, with their neighbors.
// How:  the balls are triangulated with their images up to a margin around the cell. The margin grows until one image
//       of each tetrahedron fills the cell exactly once, and neighbors agree: docs/explanation/space.md, section 28.
// Law:  edges and centers are rounded, relative to the cell by less than 2⁻⁴⁴, so that all images are doubles. For the
//       rounded ones every decision is exact, and the tetrahedra are a function of the set of balls.
// Cost: that of the triangulation, twice or more if the balls are distributed unevenly.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/progress.h"
#include "rbpa/space/balls/periodic/parts.h"
#include "rbpa/space/balls/periodic_balls.h"
#include "rbpa/space/balls/regular_triangulation.h"

namespace rbpa::space {

struct PeriodicRegular {
  static constexpr std::uint32_t none = RegularTriangulation::none;

  /// The edges by which images are moved: sums of edges of the cell, with these numbers of each.
  std::array<std::array<std::int64_t, 3>, 3> edges{};
  std::vector<std::uint32_t> ball;  ///< input ball of each image
  std::vector<Boxes> offsets;       ///< of each image from the cell, in `edges`; 0 for a ball in the cell
  std::vector<Point3> centers;      ///< of each image
  std::vector<double> radii;        ///< of each image
  RegularTriangulation cells;       ///< triangulation of the images, with neighbors; right near the cell
  std::vector<std::uint32_t> kept;  ///< the tetrahedra of `cells` of which no other is an image; they fill one cell
  /// For each kept tetrahedron, the neighbors across from its corners: images of kept ones, moved by some `edges`.
  std::vector<std::array<TetrahedronImage, 4>> neighbors;
  /// For each tetrahedron of `cells` with a corner in the cell, the position in `kept` of its image; else none.
  std::vector<std::uint32_t> kept_as;
  double margin = 0;  ///< all images are there that are at most this far from the cell
};

/// Computes the triangulation with a margin of at least `least_margin`. Along all edges the cell repeats.
/// Requires: finite centers; radii of at least 0, one for each; at least one ball.
/// Throws:   InvalidInput if the cell has no volume or edges beyond 2⁻⁹⁰⁰ to 2⁹⁰⁰, or needs too many images; Cancelled.
PeriodicRegular periodic_regular(std::span<const Point3> centers, std::span<const double> radii,
                                 const RepeatingCell& cell, double least_margin, const SolidOptions& options);

}  // namespace rbpa::space
