// What: reads the points or polygons of geometries in well-known text (OGC Simple Features; SRID=... may precede a
//       geometry, as PostGIS writes it).
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

/// The exception for a fault: its place in the text, what was found and what was expected.
struct WktFault {
  const char* at;
  std::string found;
  std::string expected;
};

/// Reads one geometry after another.
class WktGeometries {
 public:
  /// Reads points from `text`, which must outlive this object. With `vertices`, the vertices of geometries other than
  /// POINT and MULTIPOINT count as points, the point at which a ring closes once; without it, geometries of other kinds
  /// are refused.
  WktGeometries(std::string_view text, bool vertices) : text_(text), vertices_(vertices) {}
  /// Reads polygons and appends them to `polygons`, with their geometries; polygons index the points that next()
  /// appends. Refuses geometries that do not consist of polygons. A collection is one feature.
  WktGeometries(std::string_view text, PolygonFile& polygons) : text_(text), vertices_(true), polygons_(&polygons) {}

  /// Appends the points of the next geometry; returns false if there is none. Throws WktFault.
  bool next(std::vector<Point>& points);

  /// Returns the heights of the points that next() has appended; measures do not count.
  const Heights& heights() const { return heights_; }
  /// Returns the height of each point that next() has appended; NaN for a point without height.
  const std::vector<double>& z() const { return z_; }

  /// Returns the lines and rings of the points that next() has appended.
  const std::vector<PointLine>& lines() const { return lines_; }

  /// Returns the coordinate system that an SRID names; nothing if there is none.
  const std::optional<Crs>& crs() const { return crs_; }
  /// Returns the warning about an SRID that names no horizontal system; empty if there is none.
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
  std::vector<PointLine> lines_ = {};
};

/// Reads the points of POINT and MULTIPOINT, and with `vertices` those of all geometries. Throws BadInput that names
/// the line; Cancelled.
PointFile read_wkt_points(std::string_view text, const std::string& name, bool vertices);

/// Reads the polygons of POLYGON, MULTIPOLYGON and other geometries of rings. Throws BadInput that names the line, also
/// for any other geometry; Cancelled.
PolygonFile read_wkt_polygons(std::string_view text, const std::string& name);

}  // namespace rbpa::app
