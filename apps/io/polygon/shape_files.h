// What: a shape as files of geographic information systems: its polygons, and the points that are in none.
// Law:  the bytes depend on polygons and points alone; coordinates read back to the same doubles; points are in the order
//       of the input.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/crs.h"
#include "io/formats.h"
#include "io/polygon/antimeridian.h"
#include "rbpa/base/point.h"
#include "rbpa/groups.h"
#include "rbpa/shape.h"

namespace rbpa::app {

struct Shape {
  std::span<const Point> points;
  std::span<const Polygon> polygons;
  /// For each point the index of the polygon that it is in, if any.
  std::span<const std::optional<std::uint32_t>> polygon_of;
  std::optional<Crs> crs = std::nullopt;      ///< where it is known
  bool degrees = false;                       ///< the points are longitudes and latitudes, whatever is known of the crs
  std::span<const std::uint32_t> index = {};  ///< of each point among those of the input; none where that is its number
};

/// How many points are in each polygon: each point counts in one.
std::vector<std::size_t> points_in_polygons(const Shape& shape);

/// Whether coordinates are longitudes and latitudes, and some lie beyond the antimeridian: GeoJSON has them cut there.
bool is_cut_in_geojson(std::span<const Point> points, const std::optional<Crs>& crs, bool degrees);

/// Why readers may take the coordinates for something else, if they may.
std::optional<std::string> geojson_caution(const Shape& shape);

/// What begins a FeatureCollection: "crs", where it is to be said, and features follow, with commas between, then "]}".
std::string geojson_collection(const std::optional<Crs>& crs);

/// What is known of a polygon beside its rings.
struct PolygonFacts {
  double area = 0;
  double perimeter = 0;
  std::uint64_t holes = 0;
  std::uint64_t points = 0;  ///< in it and in none before it
};

/// Who takes polygons ring by ring.
class PolygonSink {
 public:
  PolygonSink() = default;
  virtual ~PolygonSink() = default;
  PolygonSink(const PolygonSink&) = delete;
  PolygonSink& operator=(const PolygonSink&) = delete;

  /// Its rings follow: the shell, then the holes, whose first points are not repeated; then end().
  virtual void begin(const PolygonFacts& facts) = 0;
  virtual void ring(std::span<const Point> points) = 0;
  virtual void end() = 0;
  /// That were all polygons.
  virtual void finish() = 0;
};

struct PolygonSigns;

/// The geometry of GeoJSON of a polygon, or of its parts where `cuts`: Polygon or MultiPolygon, as an object. With
/// `has_z` positions have three numbers.
void write_geojson_polygon(OutputFile& file, const std::vector<PositionRing>& polygon, bool cuts, bool has_z);

/// GeoJSON (RFC 7946): a FeatureCollection with one Feature for each polygon, whose properties are "number", from 1,
/// "area", "perimeter", "holes", how many, and "points", how many are in it and in none before it. An area beyond the
/// range of double is null. A system other than WGS 84 is a member "crs". A polygon on both sides of longitude 180 is cut
/// there, where coordinates are degrees (antimeridian.h): its geometry is a MultiPolygon.
/// Well-known text: one MULTIPOLYGON, or MULTIPOLYGON EMPTY.
class PolygonWriter final : public PolygonSink {
 public:
  /// Requires: geojson or wkt. `cuts`: longitudes are beyond the antimeridian.
  PolygonWriter(OutputFile& file, Format format, const std::optional<Crs>& crs, bool cuts);
  void begin(const PolygonFacts& facts) override;
  void ring(std::span<const Point> points) override;
  void end() override;
  void finish() override;

 private:
  OutputFile& file_;
  const PolygonSigns& signs_;
  std::uint64_t number_ = 0;
  bool any_ring_ = false, cuts_ = false;
  std::vector<PositionRing> rings_ = {};  ///< of the polygon, where it may be cut
};

/// All polygons of a shape by a PolygonWriter.
void write_polygons(OutputFile& file, Format format, const Shape& shape);

/// The name of a group as JSON has it: a number, or a text.
std::string json_name(const std::string& name, bool is_number);
/// A field of CSV, in quotes where it needs them.
std::string csv_text(std::string_view text);

/// Shapes of groups, each with a name.
struct NamedShapes {
  std::span<const Point> points;
  std::span<const std::string> names;
  bool are_numbers = false;            ///< all names are
  std::span<const std::size_t> sizes;  ///< points in each group
  const GroupShapes& shapes;
  std::optional<Crs> crs = std::nullopt;
  bool degrees = false;
};

/// Of each group, why it has no polygon; empty where it has one.
std::vector<std::string_view> problems_of(const NamedShapes& groups);

/// GeoJSON: one Feature for each group, with a MultiPolygon and "group", a number or a text, "points", "alpha", "area",
/// "perimeter", "polygons", and where there are none "problem".
void write_groups_geojson(OutputFile& file, const NamedShapes& groups);

/// CSV: group,points,alpha,area,perimeter,polygons,problem,geometry, a line for each group, the last being well-known text.
void write_groups_csv(OutputFile& file, const NamedShapes& groups);

/// CSV: x,y,polygon for every point, polygons numbered from 1 as in GeoJSON; nothing where it is in none.
void write_points_csv(OutputFile& file, const Shape& shape);

/// The points in no polygon, with their indices in the input from 0: CSV x,y,index; a GeoJSON FeatureCollection of Points
/// with "index"; or one MULTIPOINT.
void write_isolated_csv(OutputFile& file, const Shape& shape);
void write_isolated_geojson(OutputFile& file, const Shape& shape);
void write_isolated_wkt(OutputFile& file, const Shape& shape);

}  // namespace rbpa::app
