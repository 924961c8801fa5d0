// What: reads the points or polygons of geometries in well-known text (OGC Simple Features; perhaps SRID=... before it,
//       as PostGIS writes it).
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

/// A fault and its place in the text.
struct WktFault {
  const char* at;
  std::string found;
  std::string expected;
};

/// Reads one geometry after the other.
class WktGeometries {
 public:
  /// Reads points. With `vertices`, the vertices of geometries other than POINT and MULTIPOINT count as points, the
  /// point at which a ring closes once; otherwise these geometries are refused.
  WktGeometries(std::string_view text, bool vertices) : text_(text), vertices_(vertices) {}
  /// Reads polygons and appends them to `polygons`, with their geometries; refuses geometries that are not made of
  /// polygons. A collection is one feature.
  WktGeometries(std::string_view text, PolygonFile& polygons) : text_(text), vertices_(true), polygons_(&polygons) {}

  /// Appends the points of the next geometry; returns false if there is none. Throws WktFault.
  bool next(std::vector<Point>& points);

  /// Returns the third coordinates so far, without measures.
  const Heights& heights() const { return heights_; }
  /// Returns the third coordinate of each point that next() has appended; NaN for a point without.
  const std::vector<double>& z() const { return z_; }

  /// Returns the system that an SRID names, if any.
  const std::optional<Crs>& crs() const { return crs_; }
  /// Returns the warning about an SRID that names no horizontal system.
  const std::string& crs_warning() const { return crs_warning_; }

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
  std::string crs_warning_ = {};
  bool measured_ = false;  // the third coordinate of the current geometry is a measure
  Heights heights_ = {};
  std::vector<double> z_ = {};
};

/// Reads the points of POINT and MULTIPOINT, and with `vertices` those of all geometries. Throws BadInput naming the
/// line.
PointFile read_wkt_points(std::string_view text, const std::string& name, bool vertices);

/// Reads the polygons of POLYGON, MULTIPOLYGON and other geometries of rings. Throws BadInput naming the line, also for
/// any other geometry.
PolygonFile read_wkt_polygons(std::string_view text, const std::string& name);

}  // namespace rbpa::app
