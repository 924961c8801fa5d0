// What: the points of geometries in well-known text (OGC Simple Features; SRID=... before it, as PostGIS has it).
// Law:  a coordinate is the double nearest to its decimal text.
// Cost: one pass.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/crs.h"
#include "io/point_file.h"
#include "io/polygon/polygon_file.h"
#include "rbpa/base/point.h"

namespace rbpa::app {

/// What is wrong, and where in the text.
struct WktFault {
  const char* at;
  std::string found;
  std::string expected;
};

/// One geometry after the other.
class WktGeometries {
 public:
  /// Of other geometries than POINT and MULTIPOINT the vertices count as points, if so wanted; the point at which a ring
  /// closes counts once.
  WktGeometries(std::string_view text, bool vertices) : text_(text), vertices_(vertices) {}
  /// Polygons and what is made of them: these are appended to `polygons`, with their geometries, and other geometries are
  /// refused. A collection is one feature.
  WktGeometries(std::string_view text, PolygonFile& polygons) : text_(text), vertices_(true), polygons_(&polygons) {}

  /// Appends the points of the next geometry; false when there is none. Throws WktFault.
  bool next(std::vector<Point>& points);

  /// Third coordinates so far, but for measures.
  const Heights& heights() const { return heights_; }
  /// Of each point that next() has appended; NaN where it has none.
  const std::vector<double>& z() const { return z_; }

  /// The system that an SRID has named, if any.
  const std::optional<Crs>& crs() const { return crs_; }
  /// The warning on an SRID that names no system of the plane.
  const std::string& crs_remark() const { return crs_remark_; }

 private:
  void take_srid();
  void take_geometry(std::vector<Point>& points, int depth);
  void take_lists(std::vector<Point>& points, int brackets, bool rings);
  void take_ring(std::vector<Point>& points);
  void take_list(std::vector<Point>& points);
  bool take_empty();
  void take_position(std::vector<Point>& points);
  std::string_view take_word();
  bool take_sign(char sign);
  void expect_sign(char sign);
  void skip_space();
  [[noreturn]] void refuse(const std::string& expected) const;

  std::string_view text_;
  bool vertices_;
  PolygonFile* polygons_ = nullptr;
  std::optional<Crs> crs_ = std::nullopt;
  std::string crs_remark_ = {};
  bool measured_ = false;  // the third coordinate of the current geometry is a measure
  Heights heights_ = {};
  std::vector<double> z_ = {};
};

/// Those of POINT and MULTIPOINT, and with `vertices` those of all geometries. Throws BadInput naming the line.
PointFile read_wkt_points(std::string_view text, const std::string& name, bool vertices);

/// The polygons of POLYGON, MULTIPOLYGON and what else is made of rings. Throws BadInput naming the line, also where there
/// is anything else.
PolygonFile read_wkt_polygons(std::string_view text, const std::string& name);

}  // namespace rbpa::app
