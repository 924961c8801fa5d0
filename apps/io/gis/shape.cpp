#include "io/gis/shape.h"

namespace rbpa::app {

std::vector<std::size_t> points_in_polygons(const Shape& shape) {
  std::vector<std::size_t> counts(shape.polygons.size(), 0);
  for (const std::optional<std::uint32_t>& polygon : shape.polygon_of)
    if (polygon) ++counts[*polygon];
  return counts;
}

}  // namespace rbpa::app
