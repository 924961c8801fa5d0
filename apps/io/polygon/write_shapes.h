// What: writes files for geographic information systems: a shape, that is, polygons, the points in no polygon, and the
//       polygon of each point; shapes of groups; triangles with heights and attributes. ogr.h writes formats of GDAL.
// Law:  the bytes are a function of the arguments alone. Coordinates read back to the same doubles, except where
//       GeoJSON is cut at the antimeridian. Points are in the order of the input.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/crs.h"
#include "io/formats.h"
#include "io/polygon/antimeridian.h"
#include "io/polygon/attributes.h"
#include "rbpa/base/point.h"
#include "rbpa/base/point3.h"
#include "rbpa/plane/groups.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa::app {

struct Shape {
  std::span<const Point> points;  ///< points of the input, then further corners of the polygons if there are any
  std::span<const Polygon> polygons;
  /// For each point of the input the index of its polygon; nothing for a point in no polygon.
  std::span<const std::optional<std::uint32_t>> polygon_of;
  std::optional<Crs> crs = std::nullopt;      ///< the coordinate system, if it is known
  bool degrees = false;                       ///< the points are longitudes and latitudes, even if `crs` is unknown
  std::span<const std::uint32_t> index = {};  ///< input index of each point; empty if point i has index i
  std::span<const PointColumn> fields = {};   ///< written where points are listed
  std::span<const Attribute> summaries = {};  ///< further attributes of the polygons
  bool may_share_edges = false;  ///< polygons may have common edges, as cells do, and are then no valid MULTIPOLYGON
};

/// Returns for each polygon the number of points that shape.polygon_of assigns to it.
std::vector<std::size_t> points_in_polygons(const Shape& shape);

/// Returns whether coordinates are longitudes and latitudes, and some lie beyond the antimeridian, where GeoJSON must
/// be cut.
bool is_cut_in_geojson(std::span<const Point> points, const std::optional<Crs>& crs, bool degrees);

/// Returns a warning if readers of GeoJSON may misinterpret the coordinates; else nothing.
std::optional<std::string> geojson_caution(const Shape& shape);

/// Returns the beginning of a FeatureCollection, with "crs" unless the system is WGS 84 or unknown. The caller adds
/// Features with commas between them, and "]}".
std::string geojson_collection(const std::optional<Crs>& crs);

/// Facts about a polygon in addition to its rings.
struct PolygonFacts {
  double area = 0;
  double perimeter = 0;
  std::uint64_t holes = 0;
  std::uint64_t points = 0;  ///< number of points in this polygon and in no earlier one
};

/// A receiver of polygons, ring by ring.
class PolygonSink {
 public:
  PolygonSink() = default;
  virtual ~PolygonSink() = default;
  PolygonSink(const PolygonSink&) = delete;
  PolygonSink& operator=(const PolygonSink&) = delete;

  /// Begins a polygon. The caller then calls ring() for the shell and for each hole, without closing points, and then
  /// end().
  virtual void begin(const PolygonFacts& facts) = 0;
  virtual void ring(std::span<const Point> points) = 0;
  virtual void end() = 0;
  /// Ends the list of polygons. Call once, last.
  virtual void finish() = 0;
};

struct PolygonSigns;

/// Writes the geometry of a polygon as an object of GeoJSON: a Polygon; or, if `cuts` is true and the polygon is cut at
/// the antimeridian, a MultiPolygon of its parts. With `has_z` positions have three numbers.
void write_geojson_polygon(OutputFile& file, const std::vector<PositionRing>& polygon, bool cuts, bool has_z);

/// Writes polygons as GeoJSON or well-known text. GeoJSON (RFC 7946): a FeatureCollection with one Feature for each
/// polygon, whose properties are "number", from 1, "area", "perimeter", "holes" (their number) and "points" (the number
/// of points in this polygon and in no earlier one). An area beyond the range of double is null. A system other than
/// WGS 84 is a member "crs". If coordinates are degrees, a polygon on both sides of longitude 180 is cut there
/// (antimeridian.h), and its geometry is a MultiPolygon. Well-known text: one MULTIPOLYGON; of
/// polygons that may share edges, which no MULTIPOLYGON may, one GEOMETRYCOLLECTION of POLYGONs. Each may be EMPTY.
class PolygonWriter final : public PolygonSink {
 public:
  /// Requires: `format` is geojson or wkt. With `cuts`, polygons are cut at the antimeridian. Keeps a reference to
  /// `file`; all members throw as OutputFile::write().
  PolygonWriter(OutputFile& file, Format format, const std::optional<Crs>& crs, bool cuts,
                bool may_share_edges = false);
  void begin(const PolygonFacts& facts) override { begin(facts, ""); }
  /// Begins a polygon with further members of its properties in GeoJSON, each after a comma.
  void begin(const PolygonFacts& facts, std::string_view more);
  void ring(std::span<const Point> points) override;
  void end() override;
  void finish() override;

 private:
  OutputFile& file_;
  const PolygonSigns& signs_;
  std::uint64_t number_ = 0;
  bool any_ring_ = false, cuts_ = false;
  std::vector<PositionRing> rings_ = {};  ///< rings of the current polygon, if it may have to be cut
};

/// Writes all polygons of a shape with a PolygonWriter. Requires: `format` is geojson or wkt.
void write_polygons(OutputFile& file, Format format, const Shape& shape);

/// Returns the name of a group as JSON: unchanged if `is_number`, else in quotes.
std::string json_name(const std::string& name, bool is_number);

/// Shapes of groups, each with a name.
struct NamedShapes {
  std::span<const Point> points;
  std::span<const std::string> names;
  bool are_numbers = false;            ///< all names are numbers
  std::span<const std::size_t> sizes;  ///< number of points in each group
  const GroupShapes& shapes;
  std::optional<Crs> crs = std::nullopt;
  bool degrees = false;
  std::span<const Attribute> attributes = {};  ///< further attributes of the groups
  std::size_t first = 0;                       ///< number of the first of these groups in `attributes`
};

/// The properties of a group.
struct GroupFacts {
  std::string name;  ///< as JSON
  std::uint64_t points = 0;
  double alpha = 0;
  PolygonTotals totals = {};
  std::uint64_t polygons = 0;
  std::string more = {};          ///< further members, each after a comma
  std::string_view problem = {};  ///< why there is no polygon
};

/// Writes GeoJSON of groups, as write_groups_geojson() does, one group after another.
class GroupsWriter {
 public:
  /// With `cuts`, polygons are cut at the antimeridian. Keeps a reference to `file`.
  GroupsWriter(OutputFile& file, const std::optional<Crs>& crs, bool cuts);
  /// Writes a group, whose polygons show(sink) gives to a sink.
  void write(const GroupFacts& group, const std::function<void(PolygonSink&)>& show);
  void finish();

 private:
  OutputFile& file_;
  bool cuts_, any_ = false;
};

void write_groups(GroupsWriter& writer, const NamedShapes& groups);

/// Returns for each group the reason why it has no polygon; an empty text if it has one.
std::vector<std::string_view> problems_of(const NamedShapes& groups);

/// Writes GeoJSON: one Feature for each group, with a MultiPolygon and "group", a number or a text, "points", "alpha",
/// "area", "perimeter", "polygons", the attributes, and, if the group has no polygon, "problem".
void write_groups_geojson(OutputFile& file, const NamedShapes& groups);

/// Writes CSV with columns group,points,alpha,area,perimeter,polygons,problem,geometry and the attributes, one line for
/// each group; the geometry is well-known text.
void write_groups_csv(OutputFile& file, const NamedShapes& groups);

/// Writes CSV with columns x,y,polygon and fields, one line for each point; polygons are numbered from 1 as in GeoJSON,
/// and the number is empty for a point in no polygon.
void write_points_csv(OutputFile& file, const Shape& shape);

/// Write the points in no polygon, with their input indices from 0: CSV with columns x,y,index and fields; a GeoJSON
/// FeatureCollection of Points with "index" and fields; or one MULTIPOINT.
void write_isolated_csv(OutputFile& file, const Shape& shape);
void write_isolated_geojson(OutputFile& file, const Shape& shape);
void write_isolated_wkt(OutputFile& file, const Shape& shape);

/// A number or a text for each triangle.
struct TriangleAttribute {
  std::string name;
  std::function<double(std::size_t)> number = {};     ///< value of triangle i; NaN if it has none
  std::function<std::string(std::size_t)> text = {};  ///< value of triangle i; set only if the attribute is a text
};

struct TriangleTable {
  std::size_t count = 0;
  std::function<std::array<Point3, 3>(std::size_t)> corners = {};  ///< corners of triangle i, counter-clockwise
  bool has_z = false;                                              ///< positions have three numbers, not two
  std::vector<TriangleAttribute> attributes = {};
  std::span<const Point> points = {};  ///< all points that may be corners
  std::optional<Crs> crs = std::nullopt;
  bool degrees = false;  ///< x is a longitude and y a latitude
};

/// Writes a FeatureCollection with a Feature for each triangle: a Polygon with the properties "number", from 1, and the
/// attributes.
void write_triangles_geojson(OutputFile& file, const TriangleTable& triangles);

}  // namespace rbpa::app
