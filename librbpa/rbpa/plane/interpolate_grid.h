// What: interpolates values of points on a raster of square cells, such as a terrain model from ground points.
// Law:  a value is that of Locator::interpolate() at the center of its cell: it does not depend on threads, or on the
//       order of the points.
// Cost: that of Locator::interpolate(); memory for a million cells at a time, however many there are.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/locate.h"

namespace rbpa {

/// A raster of square cells. Rows are counted from the top, the greatest y, as in most files of rasters.
struct Raster {
  Point origin = {};  ///< lower left corner
  double cell = 1;    ///< side of the cells
  std::size_t columns = 0, rows = 0;

  Point center(std::size_t row, std::size_t column) const {
    return {origin.x + (static_cast<double>(column) + 0.5) * cell,
            origin.y + (static_cast<double>(rows - 1 - row) + 0.5) * cell};
  }
};

/// Returns the smallest raster, of at least one cell, that covers a box, and whose sides are at multiples of `cell`, up
/// to rounding: rasters of neighboring tiles fit together.
/// Throws: InvalidInput when `cell` is not a finite number above 0, or so small that there would be more than 2^31 − 1
///         columns or rows, more than 10^11 cells, or sides that doubles do not distinguish.
RBPA_API Raster raster_around(const Point& least, const Point& greatest, double cell);

/// Receives the values of the next cells, row by row from the top, and in each row from the left; a row may be split.
using TakeCells = std::function<void(std::span<const double>)>;

/// Interpolates `values`, one for each point, at the center of each cell, and calls take() in the calling thread until
/// all cells are taken. NaN stands for no value: no triangle of circumradius ≤ options.alpha contains the center.
/// Throws: the exceptions of Locator::interpolate(), and of take().
RBPA_API void interpolate_grid(const Locator& locator, std::span<const double> values, const Raster& raster,
                               const TakeCells& take, const InterpolateOptions& options = {});

}  // namespace rbpa
