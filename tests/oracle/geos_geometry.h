// What: polygons as GEOS sees them.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rbpa/shape.h"

namespace rbpa_test {

/// A geometry of GEOS: a polygon, or a collection of them.
class GeosGeometry {
 public:
  /// A multipolygon.
  static GeosGeometry of(const std::vector<rbpa::Polygon>& polygons, std::span<const rbpa::Point> points);
  /// Throws std::runtime_error when GEOS cannot read the text.
  static GeosGeometry from_wkt(const std::string& text);
  static GeosGeometry from_geojson(const std::string& text);

  std::size_t parts() const;
  GeosGeometry part(std::size_t i) const;
  std::size_t holes() const;  ///< of a polygon

  /// Why and where the geometry is invalid under OGC Simple Features; "" when it is valid.
  std::string invalid() const;
  double area() const;
  double perimeter() const;
  /// The shell of a polygon is counter-clockwise, and no hole is.
  bool runs_as_it_should() const;
  /// The same rings in the same order with the same coordinates, to the last bit.
  bool is_exactly(const GeosGeometry& other) const;

 private:
  struct Inside;
  explicit GeosGeometry(std::shared_ptr<Inside> inside) : inside_(std::move(inside)) {}
  std::shared_ptr<Inside> inside_;
};

}  // namespace rbpa_test
