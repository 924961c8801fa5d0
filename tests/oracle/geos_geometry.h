// What: polygons as GEOS geometries.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rbpa/plane/outline_polygons.h"

namespace rbpa_test {

/// Geometry of GEOS: a polygon, or a collection of polygons.
class GeosGeometry {
 public:
  /// Makes a multipolygon.
  static GeosGeometry of(const std::vector<rbpa::Polygon>& polygons, std::span<const rbpa::Point> points);
  /// Parses WKT. Throws std::runtime_error when GEOS cannot read the text.
  static GeosGeometry from_wkt(const std::string& text);
  static GeosGeometry from_geojson(const std::string& text);

  std::size_t parts() const;
  GeosGeometry part(std::size_t i) const;
  std::size_t holes() const;  ///< number of holes of a polygon

  /// Returns why and where the geometry is invalid under OGC Simple Features; "" when it is valid.
  std::string invalid() const;
  double area() const;
  double perimeter() const;
  /// Returns whether the shell of a polygon is counter-clockwise, and every hole clockwise.
  bool runs_as_it_should() const;
  /// Returns whether both have the same rings in the same order with the same coordinates, to the last bit.
  bool is_exactly(const GeosGeometry& other) const;

 private:
  struct Inside;
  explicit GeosGeometry(std::shared_ptr<Inside> inside) : inside_(std::move(inside)) {}
  std::shared_ptr<Inside> inside_;
};

}  // namespace rbpa_test
