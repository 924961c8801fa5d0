#include "rbpa/plane/interpolate_grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"

namespace rbpa {

Raster raster_around(const Point& least, const Point& greatest, double cell) {
  if (!(cell > 0 && std::isfinite(cell)))
    throw InvalidInput("cell: found " + text(cell) + ", expected a finite size above 0");
  constexpr double most_on_side = 0x1p31 - 1, most_cells = 1e11, exact = 0x1p52;
  const auto first = [&](double from) { return std::floor(from / cell); };
  const auto number = [&](double from, double to) { return std::max(1.0, std::ceil(to / cell) - first(from)); };
  const double columns = number(least.x, greatest.x), rows = number(least.y, greatest.y);
  const double farthest = std::max({std::abs(least.x), std::abs(least.y), std::abs(greatest.x), std::abs(greatest.y)});
  if (!(columns <= most_on_side && rows <= most_on_side && columns * rows <= most_cells && farthest / cell < exact))
    throw InvalidInput("cell: found " + text(cell) + ", which makes " + text(columns) + " columns and " + text(rows) +
                       " rows here, expected a size with at most 2147483647 of each and 100000000000 cells");
  return {{first(least.x) * cell, first(least.y) * cell},
          cell,
          static_cast<std::size_t>(columns),
          static_cast<std::size_t>(rows)};
}

void interpolate_grid(const Locator& locator, std::span<const double> values, const Raster& raster,
                      const TakeCells& take, const InterpolateOptions& options) {
  constexpr std::size_t cells_at_a_time = std::size_t{1} << 20U;
  const std::size_t cells = raster.columns * raster.rows;
  std::vector<Point> centers;
  for (std::size_t first = 0; first < cells; first += centers.size()) {
    centers.resize(std::min(cells_at_a_time, cells - first));
    for (std::size_t i = 0; i < centers.size(); ++i)
      centers[i] = raster.center((first + i) / raster.columns, (first + i) % raster.columns);
    take(locator.interpolate(values, 1, centers, options));
  }
}

}  // namespace rbpa
