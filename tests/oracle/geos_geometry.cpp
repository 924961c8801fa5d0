#include "oracle/geos_geometry.h"

#include <geos_c.h>

#include <stdexcept>
#include <utility>

namespace rbpa_test {
namespace {

/// Returns the one context of the test, which has one thread.
GEOSContextHandle_t context() {
  static const std::unique_ptr<GEOSContextHandle_HS, decltype(&GEOS_finish_r)> handle(GEOS_init_r(), GEOS_finish_r);
  return handle.get();
}

GEOSGeometry* ring_of(const rbpa::Ring& ring, std::span<const rbpa::Point> points) {
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context(), static_cast<unsigned>(ring.points.size() + 1), 2);
  for (unsigned i = 0; i <= ring.points.size(); ++i) {
    const rbpa::Point& p = points[ring.points[i % ring.points.size()]];
    GEOSCoordSeq_setXY_r(context(), sequence, i, p.x, p.y);
  }
  return GEOSGeom_createLinearRing_r(context(), sequence);
}

}  // namespace

struct GeosGeometry::Inside {
  explicit Inside(GEOSGeometry* made) : whole(made), at(made) {
    if (made == nullptr) throw std::runtime_error("GEOS has made no geometry");
  }
  Inside(std::shared_ptr<Inside> parent, const GEOSGeometry* part) : owner(std::move(parent)), at(part) {}
  ~Inside() {
    if (whole != nullptr) GEOSGeom_destroy_r(context(), whole);
  }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

  std::shared_ptr<Inside> owner = nullptr;  // of a part, the whole
  GEOSGeometry* whole = nullptr;
  const GEOSGeometry* at;
};

GeosGeometry GeosGeometry::of(const std::vector<rbpa::Polygon>& polygons, std::span<const rbpa::Point> points) {
  std::vector<GEOSGeometry*> made;
  for (const rbpa::Polygon& polygon : polygons) {
    std::vector<GEOSGeometry*> holes;
    for (const rbpa::Ring& hole : polygon.holes) holes.push_back(ring_of(hole, points));
    made.push_back(GEOSGeom_createPolygon_r(context(), ring_of(polygon.shell, points), holes.data(),
                                            static_cast<unsigned>(holes.size())));
  }
  return GeosGeometry(std::make_shared<Inside>(
      GEOSGeom_createCollection_r(context(), GEOS_MULTIPOLYGON, made.data(), static_cast<unsigned>(made.size()))));
}

GeosGeometry GeosGeometry::from_wkt(const std::string& text) {
  const std::unique_ptr<GEOSWKTReader, void (*)(GEOSWKTReader*)> reader(
      GEOSWKTReader_create_r(context()), [](GEOSWKTReader* r) { GEOSWKTReader_destroy_r(context(), r); });
  return GeosGeometry(std::make_shared<Inside>(GEOSWKTReader_read_r(context(), reader.get(), text.c_str())));
}

GeosGeometry GeosGeometry::from_geojson(const std::string& text) {
  const std::unique_ptr<GEOSGeoJSONReader, void (*)(GEOSGeoJSONReader*)> reader(
      GEOSGeoJSONReader_create_r(context()), [](GEOSGeoJSONReader* r) { GEOSGeoJSONReader_destroy_r(context(), r); });
  return GeosGeometry(
      std::make_shared<Inside>(GEOSGeoJSONReader_readGeometry_r(context(), reader.get(), text.c_str())));
}

std::size_t GeosGeometry::parts() const {
  return static_cast<std::size_t>(GEOSGetNumGeometries_r(context(), inside_->at));
}

GeosGeometry GeosGeometry::part(std::size_t i) const {
  return GeosGeometry(
      std::make_shared<Inside>(inside_, GEOSGetGeometryN_r(context(), inside_->at, static_cast<int>(i))));
}

std::size_t GeosGeometry::holes() const {
  return static_cast<std::size_t>(GEOSGetNumInteriorRings_r(context(), inside_->at));
}

std::string GeosGeometry::invalid() const {
  char* reason = nullptr;
  GEOSGeometry* where = nullptr;
  const char valid = GEOSisValidDetail_r(context(), inside_->at, 0, &reason, &where);
  std::string text;
  if (valid != 1) text = reason == nullptr ? "GEOS has failed" : reason;
  if (reason != nullptr) GEOSFree_r(context(), reason);
  if (where != nullptr) GEOSGeom_destroy_r(context(), where);
  return text;
}

double GeosGeometry::area() const {
  double area = 0;
  GEOSArea_r(context(), inside_->at, &area);
  return area;
}

double GeosGeometry::perimeter() const {
  double length = 0;
  GEOSLength_r(context(), inside_->at, &length);
  return length;
}

bool GeosGeometry::runs_as_it_should() const {
  const auto is_ccw = [](const GEOSGeometry* ring) {
    char ccw = 0;
    GEOSCoordSeq_isCCW_r(context(), GEOSGeom_getCoordSeq_r(context(), ring), &ccw);
    return ccw == 1;
  };
  if (!is_ccw(GEOSGetExteriorRing_r(context(), inside_->at))) return false;
  for (std::size_t i = 0; i < holes(); ++i)
    if (is_ccw(GEOSGetInteriorRingN_r(context(), inside_->at, static_cast<int>(i)))) return false;
  return true;
}

bool GeosGeometry::is_exactly(const GeosGeometry& other) const {
  return GEOSEqualsExact_r(context(), inside_->at, other.inside_->at, 0) == 1;
}

}  // namespace rbpa_test
