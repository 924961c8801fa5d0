// What: polygons with holes as flat arrays: the points of one ring after another, the shell of each polygon before its
//       holes; the index of the first point of each ring, and that of the first ring of each polygon, both with the end
//       as a last entry.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "python/arrays.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/partial.h"

namespace rbpa::python {

/// Polygons as flat arrays. `Index` is the type of the index of a point: 32 bits, or 64 bits if Python does not have
/// the points; only then `coordinates` is filled.
template <typename Index>
struct FlatPolygons {
  std::vector<Index> indices = {};
  std::vector<Point> coordinates = {};
  std::vector<std::int64_t> ring_begin = {0}, polygon_begin = {0};
  std::vector<double> areas = {}, perimeters = {};

  template <typename AnyPolygon>
  void add(const AnyPolygon& polygon) {
    add_ring(polygon.shell);
    for (const auto& hole : polygon.holes) add_ring(hole);
    polygon_begin.push_back(static_cast<std::int64_t>(ring_begin.size()) - 1);
    areas.push_back(polygon.area);
    perimeters.push_back(polygon.perimeter);
  }

  /// Returns the content as NumPy arrays, and leaves this object empty.
  py::dict as_arrays() {
    py::dict result;
    result["indices"] = line<std::make_signed_t<Index>>(std::move(indices));
    result["ring_begin"] = line<std::int64_t>(std::move(ring_begin));
    result["polygon_begin"] = line<std::int64_t>(std::move(polygon_begin));
    result["areas"] = line<double>(std::move(areas));
    result["perimeters"] = line<double>(std::move(perimeters));
    return result;
  }

  /// Returns as_arrays() with the area and perimeter of all polygons.
  py::dict as_arrays(const PolygonTotals& totals) {
    py::dict result = as_arrays();
    result["area"] = totals.area;
    result["perimeter"] = totals.perimeter;
    return result;
  }

 private:
  void add_ring(const Ring& ring) {
    indices.insert(indices.end(), ring.points.begin(), ring.points.end());
    ring_begin.push_back(static_cast<std::int64_t>(indices.size()));
  }
  void add_ring(const CornerRing& ring) {
    for (const Corner& corner : ring) {
      indices.push_back(corner.index);
      coordinates.push_back(corner.at);
    }
    ring_begin.push_back(static_cast<std::int64_t>(indices.size()));
  }
};

}  // namespace rbpa::python
