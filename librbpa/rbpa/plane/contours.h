// What: finds contour lines: where the linear interpolation of values in triangles has given levels.
// Law:  the line of a level is the limit of those of lower levels, so that a point whose value is the level is above
//       it, by symbolic perturbation. Hence each line is closed or ends at the boundary of the triangles, and no two
//       lines cross; lines may touch or overlap at points and edges whose value is the level. The result does not
//       depend on threads, or on the order of the points.
// Cost: linear in triangles and corners of lines, and a search for each corner.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

struct Contour {
  std::size_t level = 0;   ///< index of the level
  bool is_closed = false;  ///< the last point is joined with the first, which is not repeated
  /// Two points or more, with higher values on the left, so that lines around summits are counter-clockwise. No point
  /// equals the next. A closed line begins at the least of its points.
  std::span<const Point> points;
};

/// Contour lines, which refer to the points that this object holds: it can be moved, but not copied.
class Contours {
 public:
  Contours() = default;
  /// Requires: `lines` refer to `points`; not checked.
  Contours(std::vector<Contour> lines, std::vector<Point> points)
      : lines_(std::move(lines)), points_(std::move(points)) {}
  Contours(Contours&&) = default;
  Contours& operator=(Contours&&) = default;

  std::size_t size() const { return lines_.size(); }
  bool empty() const { return lines_.empty(); }
  const Contour& operator[](std::size_t i) const { return lines_[i]; }
  auto begin() const { return lines_.begin(); }
  auto end() const { return lines_.end(); }

 private:
  std::vector<Contour> lines_;
  std::vector<Point> points_;  // of all lines, one after another
};

struct ContourOptions {
  MaxThreads threads = 0;  ///< maximum number; 0: all processors
  GoOn go_on = {};         ///< callback for cancellation
};

/// Returns the contour lines of all levels, in the order of levels, and lines of a level by their points in
/// lexicographic order. `values` has a number for each point.
/// Requires: counter-clockwise triangles with neighbors, as alpha_complex() returns them for any alpha.
/// Throws:   InvalidInput when there is not one finite value for each point, or the levels are not finite or not
///           strictly ascending; ContractViolation as require_linked(); Cancelled.
RBPA_API Contours contours(std::span<const Point> points, const TriangleArrays& triangles,
                           std::span<const double> values, std::span<const double> levels,
                           const ContourOptions& options = {});

/// Returns the multiples of `step` that are above the least and not above the greatest of the values: the levels that
/// contours() may find.
/// Throws: InvalidInput when `step` is not a finite number above 0, or so small that the values are more than 100,000
///         steps apart or 2^52 steps from 0.
RBPA_API std::vector<double> levels_every(double step, std::span<const double> values);

}  // namespace rbpa
