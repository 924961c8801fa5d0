#include "io/polygon/ogr.h"
#include "io/number.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/values_at.h"
#include "io/words.h"

namespace rbpa::app {
namespace {

/// Registers GDAL's drivers, and keeps GDAL from printing while this object exists.
class Gdal {
 public:
  Gdal() {
    static_cast<void>(drivers_are_known());
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~Gdal() { CPLPopErrorHandler(); }
  Gdal(const Gdal&) = delete;
  Gdal& operator=(const Gdal&) = delete;

  /// Returns whether a call of GDAL has failed since this object was made.
  bool has_failed() const { return CPLGetLastErrorType() >= CE_Failure; }
  /// Returns GDAL's message about the last failure.
  std::string reason() const {
    const std::string text = CPLGetLastErrorMsg();
    return text.empty() ? "nothing that GDAL knows" : text;
  }

 private:
  static bool drivers_are_known() {
    static const bool known = (GDALAllRegister(), true);
    return known;
  }
};

class OgrReader {
 public:
  OgrReader(const std::string& source, bool vertices) : source_(source), vertices_(vertices) {}

  PointFile read(const std::optional<std::string>& layer_name) {
    constexpr unsigned how = GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR;
    const GDALDatasetUniquePtr dataset(GDALDataset::Open(source_.c_str(), how));
    if (!dataset) throw BadInput(source_ + ": GDAL cannot read it: " + shown(gdal_.reason()));
    OGRLayer& layer = find_layer(*dataset, layer_name);
    take_crs(layer);
    layer.ResetReading();
    while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
      if (features_++ % 1024 == 0) stop_if_interrupted();
      const OGRGeometry* geometry = feature->GetGeometryRef();
      geometry == nullptr ? static_cast<void>(++without_geometry_) : take(*geometry);
    }
    // Refuse a file that can be read in part only.
    if (gdal_.has_failed())
      throw BadInput(source_ + ": GDAL cannot read all of it: " + shown(gdal_.reason()) +
                     " (ogr2ogr -skipfailures copies what it can read)");
    const GIntBig announced = layer.GetFeatureCount(FALSE);  // below 0: not known without counting
    if (announced >= 0 && static_cast<std::size_t>(announced) != features_)
      bad_input(source_, counted(features_, "feature"), std::to_string(announced) + " as the file says");
    if (without_geometry_ > 0) file_.warnings.push_back(counted(without_geometry_, "feature") + " without a geometry");
    return std::move(file_);
  }

 private:
  OGRLayer& find_layer(GDALDataset& dataset, const std::optional<std::string>& name) const {
    std::string names;
    for (OGRLayer* layer : dataset.GetLayers()) {
      if (name ? *name == layer->GetName() : dataset.GetLayerCount() == 1) return *layer;
      names += (names.empty() ? "" : ", ") + std::string(layer->GetName());
    }
    bad_input(source_, names.empty() ? "no layer" : "the layers " + names,
              name ? "one called " + in_quotes(*name) : "--layer with the name of one");
  }

  void take_crs(const OGRLayer& layer) {
    const OGRSpatialReference* const whole = const_cast<OGRLayer&>(layer).GetSpatialRef();  // does not change the layer
    if (whole == nullptr || whole->IsEmpty()) return;
    OGRSpatialReference system(*whole);
    if (system.IsCompound() != 0) system.StripVertical();
    const char* authority = system.GetAuthorityName(nullptr);
    const char* code = system.GetAuthorityCode(nullptr);
    file_.degrees = system.IsGeographic() != 0;
    if (authority != nullptr && code != nullptr && system.IsVertical() == 0)
      file_.crs = Crs{.authority = authority, .code = code, .degrees = file_.degrees};
    else
      file_.warnings.push_back("the system of coordinates, " + in_quotes(whole->GetName()) +
                               ", has no code of the plane and is not carried over (--crs EPSG:CODE names it)");
  }

  void take(const OGRPoint& p) {
    if (p.IsEmpty()) return;
    const Point point{p.getX(), p.getY()};
    if (!is_finite(point))
      bad_input(source_ + ": feature " + std::to_string(features_),
                "the point (" + text_of(point.x) + ", " + text_of(point.y) + ")", "finite coordinates");
    const bool has_z = p.Is3D() != 0;
    file_.points.push_back(point);
    file_.z.push_back(has_z ? p.getZ() : std::numeric_limits<double>::quiet_NaN());
    if (has_z) file_.heights.take(p.getZ());
  }

  void take(const OGRSimpleCurve& line, bool ring) {
    int count = line.getNumPoints();
    const bool closes = count > 1 && line.getX(0) == line.getX(count - 1) && line.getY(0) == line.getY(count - 1);
    if (ring && closes) --count;
    const std::size_t first = file_.points.size();
    for (int i = 0; i < count; ++i) {
      OGRPoint point;
      line.getPoint(i, &point);
      take(point);
    }
    file_.lines.push_back({first, file_.points.size(), ring});
  }

  void take(const OGRGeometry& geometry) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbPoint) return take(*geometry.toPoint());
    if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) take(*part);
      return;
    }
    if (!vertices_)
      bad_input(source_ + ": feature " + std::to_string(features_), geometry.getGeometryName(),
                "POINT or MULTIPOINT (--vertices takes the vertices of lines and polygons)");
    if (OGR_GT_IsSubClassOf(type, wkbLineString)) return take(*geometry.toSimpleCurve(), false);
    if (OGR_GT_IsSubClassOf(type, wkbPolygon) == 0)
      bad_input(source_ + ": feature " + std::to_string(features_), geometry.getGeometryName(),
                "points, lines or polygons (ogr2ogr -nlt CONVERT_TO_LINEAR makes them)");
    for (const OGRLinearRing* ring : *geometry.toPolygon()) take(*ring, true);
  }

  Gdal gdal_;
  const std::string& source_;
  bool vertices_;
  PointFile file_ = {};
  std::size_t features_ = 0, without_geometry_ = 0;
};

}  // namespace

bool has_gdal() { return true; }

PointFile read_ogr_points(const std::string& source, const std::optional<std::string>& layer, bool vertices) {
  return OgrReader(source, vertices).read(layer);
}

namespace {

const char* driver_of(Format format) {
  if (format == Format::gpkg) return "GPKG";
  return format == Format::fgb ? "FlatGeobuf" : "ESRI Shapefile";
}

/// Files that GDAL writes into memory, so that only complete files are written to the disk.
class OgrWriter {
 public:
  /// Without a system, the layers of a GeoPackage are in an undefined one: geographic if coordinates are `degrees`, and
  /// otherwise Cartesian.
  OgrWriter(Format format, const std::optional<Crs>& crs, bool degrees) : format_(format), path_(path_of(format)) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_of(format));
    if (driver == nullptr) fail(std::string("this GDAL has no driver ") + driver_of(format));
    dataset_.reset(driver->Create(path_.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!dataset_) fail(gdal_.reason());
    // Use one transaction for all features: a database would otherwise make one for each.
    in_transaction_ = dataset_->TestCapability(ODsCTransactions) != 0 && dataset_->StartTransaction() == OGRERR_NONE;
    const bool is_cartesian = !crs && !degrees && format == Format::gpkg;
    if (is_cartesian) system_.SetLocalCS("Undefined Cartesian SRS");  // GDAL writes its number in the standard, -1
    has_system_ = crs.has_value() || is_cartesian;
    if (!crs) return;
    system_.SetAxisMappingStrategy(
        OAMS_TRADITIONAL_GIS_ORDER);  // x is the longitude, also where EPSG orders latitude first
    if (system_.SetFromUserInput(crs->text().c_str()) != OGRERR_NONE)
      fail("--crs " + crs->text() + ": " + gdal_.reason());
  }
  ~OgrWriter() {
    dataset_.reset();
    for (const std::string& ending : ogr_endings(format_)) VSIUnlink(with(ending).c_str());
  }
  OgrWriter(const OgrWriter&) = delete;
  OgrWriter& operator=(const OgrWriter&) = delete;

  void write_polygons(const Shape& shape) {
    OGRLayer& layer = create_layer("polygons", wkbPolygon);
    for (const char* name : {"number", "holes", "points"}) add_field(layer, name, OFTInteger64);
    for (const char* name : {"area", "perimeter"}) add_field(layer, name, OFTReal);
    add_attributes(layer, shape.summaries);
    const std::vector<std::size_t> points = points_in_polygons(shape);
    for (std::size_t i = 0; i < shape.polygons.size(); ++i) {
      const Polygon& polygon = shape.polygons[i];
      OGRFeature feature(layer.GetLayerDefn());
      set(feature, "number", i + 1);
      set(feature, "holes", polygon.holes.size());
      set(feature, "points", points[i]);
      set(feature, "area", polygon.area);
      set(feature, "perimeter", polygon.perimeter);
      set(feature, shape.summaries, i);
      const OGRPolygon geometry = polygon_of(polygon, shape.points);
      add(layer, feature, geometry, i);
    }
  }

  void write_isolated(const Shape& shape) {
    OGRLayer& layer = create_layer("isolated", wkbPoint);
    add_field(layer, "index", OFTInteger64);
    const std::vector<Attribute> fields =
        attributes_of(shape.fields, {"index", layer.GetFIDColumn(), layer.GetGeometryColumn()});
    add_attributes(layer, fields);
    for (std::size_t i = 0; i < shape.polygon_of.size(); ++i) {
      if (shape.polygon_of[i]) continue;
      OGRFeature feature(layer.GetLayerDefn());
      set(feature, "index", std::size_t{renumbered(static_cast<std::uint32_t>(i), shape.index)});
      set(feature, fields, i);
      const OGRPoint geometry(shape.points[i].x, shape.points[i].y);
      add(layer, feature, geometry, i);
    }
  }

  void write_groups(const NamedShapes& groups) {
    OGRLayer& layer = create_layer("groups", wkbMultiPolygon);
    // Use real numbers: names that are numbers need not be integers.
    add_field(layer, "group", groups.are_numbers ? OFTReal : OFTString);
    for (const char* name : {"points", "polygons"}) add_field(layer, name, OFTInteger64);
    for (const char* name : {"alpha", "area", "perimeter"}) add_field(layer, name, OFTReal);
    add_field(layer, "problem", OFTString);
    add_attributes(layer, groups.attributes);
    const std::vector<std::string_view> problems = problems_of(groups);
    for (std::size_t g = 0; g < groups.names.size(); ++g) {
      const std::uint64_t first = groups.shapes.polygon_begin[g], last = groups.shapes.polygon_begin[g + 1];
      OGRFeature feature(layer.GetLayerDefn());
      feature.SetField("group", groups.names[g].c_str());  // GDAL converts it to the type of the field
      set(feature, "points", groups.sizes[g]);
      set(feature, "polygons", last - first);
      set(feature, "alpha", groups.shapes.alphas[g]);
      set(feature, "area", groups.shapes.totals[g].area);
      set(feature, "perimeter", groups.shapes.totals[g].perimeter);
      set(feature, groups.attributes, g);
      if (!problems[g].empty()) feature.SetField("problem", std::string(problems[g]).c_str());
      OGRMultiPolygon geometry;
      for (std::uint64_t i = first; i < last; ++i) {
        const OGRPolygon polygon = polygon_of(groups.shapes.polygons[i], groups.points);
        geometry.addGeometry(&polygon);
      }
      add(layer, feature, geometry, g);
    }
  }

  void write_triangles(const TriangleTable& triangles) {
    OGRLayer& layer = create_layer("triangles", triangles.has_z ? wkbPolygon25D : wkbPolygon);
    add_field(layer, "number", OFTInteger64);
    for (const TriangleAttribute& attribute : triangles.attributes)
      add_field(layer, attribute.name.c_str(), attribute.text ? OFTString : OFTReal);
    for (std::size_t i = 0; i < triangles.count; ++i) {
      OGRFeature feature(layer.GetLayerDefn());
      set(feature, "number", i + 1);
      for (std::size_t k = 0; k < triangles.attributes.size(); ++k) {
        const TriangleAttribute& attribute = triangles.attributes[k];
        const int place = static_cast<int>(k) + 1;  // by index, as GDAL may have shortened the name
        if (attribute.text)
          feature.SetField(place, attribute.text(i).c_str());
        else if (const double value = attribute.number(i); std::isfinite(value))
          feature.SetField(place, value);
      }
      auto ring = std::make_unique<OGRLinearRing>();
      const auto corners = triangles.corners(i);
      for (const std::size_t k : {0U, 1U, 2U, 0U})
        triangles.has_z ? ring->addPoint(corners[k].x, corners[k].y, corners[k].z)
                        : ring->addPoint(corners[k].x, corners[k].y);
      OGRPolygon geometry;
      geometry.addRingDirectly(ring.release());
      add(layer, feature, geometry, i);
    }
  }

  std::vector<OgrFile> files() {
    if (in_transaction_ && dataset_->CommitTransaction() != OGRERR_NONE) fail(gdal_.reason());
    dataset_.reset();  // writes the rest
    if (gdal_.has_failed()) fail(gdal_.reason());
    std::vector<OgrFile> files;
    for (const std::string& ending : ogr_endings(format_)) {
      vsi_l_offset size = 0;
      const GByte* bytes = VSIGetMemFileBuffer(with(ending).c_str(), &size, 0);
      if (bytes != nullptr) files.push_back({ending, {reinterpret_cast<const char*>(bytes), size}});
    }
    return files;
  }

 private:
  /// Returns a name of a file in memory that is unique in this process.
  static std::string path_of(Format format) {
    static int count = 0;
    return "/vsimem/rbpa-" + std::to_string(getpid()) + "-" + std::to_string(++count) + "." +
           ogr_endings(format).front();
  }
  std::string with(const std::string& ending) const { return path_.substr(0, path_.rfind('.') + 1) + ending; }

  [[noreturn]] void fail(const std::string& why) const {
    throw Failure(std::string("cannot write ") + driver_of(format_) + ": " + why);
  }

  OGRLayer& create_layer(const char* name, OGRwkbGeometryType type) {
    OGRLayer* layer = dataset_->CreateLayer(name, has_system_ ? &system_ : nullptr, type, nullptr);
    if (layer == nullptr) fail(gdal_.reason());
    return *layer;
  }
  void add_field(OGRLayer& layer, const char* name, OGRFieldType type) const {
    OGRFieldDefn field(name, type);
    if (layer.CreateField(&field) != OGRERR_NONE) fail(gdal_.reason());
  }
  /// Adds a field for each attribute. Unsigned integers of 64 bits, which OGR does not have, become texts.
  void add_attributes(OGRLayer& layer, std::span<const Attribute> attributes) const {
    for (const Attribute& attribute : attributes) {
      const PointColumn& column = *attribute.column;
      const bool is_text = column.is_text || column.type == Scalar::uint64;
      add_field(layer, attribute.name.c_str(), is_text ? OFTString : is_integer(column.type) ? OFTInteger64 : OFTReal);
    }
  }
  /// Set the last fields, which are `attributes`, or one by name; a number that is not finite is null, as in JSON.
  static void set(OGRFeature& feature, std::span<const Attribute> attributes, std::size_t index) {
    int place = feature.GetFieldCount() - static_cast<int>(attributes.size());
    for (const Attribute& attribute : attributes) {
      attribute.with_value(index, [&](const auto& value) {
        if constexpr (requires { value.c_str(); })
          feature.SetField(place, value.c_str());
        else if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(value)>>)
          feature.SetField(place, std::to_string(value).c_str());  // GDAL converts it to the type of the field
        else if (std::isfinite(value))
          feature.SetField(place, static_cast<double>(value));
      });
      ++place;
    }
  }
  static void set(OGRFeature& to, const char* name, std::size_t value) {
    to.SetField(name, static_cast<GIntBig>(value));
  }
  static void set(OGRFeature& feature, const char* name, double value) {
    if (std::isfinite(value)) feature.SetField(name, value);
  }
  static OGRPolygon polygon_of(const Polygon& polygon, std::span<const Point> points) {
    OGRPolygon geometry;
    const auto add_ring = [&](const Ring& ring) {
      auto line = std::make_unique<OGRLinearRing>();
      for (const std::uint32_t i : ring.points) line->addPoint(points[i].x, points[i].y);
      line->addPoint(points[ring.points.front()].x, points[ring.points.front()].y);
      geometry.addRingDirectly(line.release());
    };
    add_ring(polygon.shell);
    for (const Ring& hole : polygon.holes) add_ring(hole);
    return geometry;
  }
  void add(OGRLayer& layer, OGRFeature& feature, const OGRGeometry& geometry, std::size_t index) const {
    if (index % 1024 == 0) stop_if_interrupted();
    if (!geometry.IsEmpty()) feature.SetGeometry(&geometry);
    if (layer.CreateFeature(&feature) != OGRERR_NONE) fail(gdal_.reason());
  }

  Gdal gdal_;
  Format format_;
  std::string path_;
  OGRSpatialReference system_;
  bool has_system_ = false;
  GDALDatasetUniquePtr dataset_;
  bool in_transaction_ = false;
};

}  // namespace

std::vector<OgrFile> ogr_polygons(Format format, const Shape& shape) {
  OgrWriter writer(format, shape.crs, shape.degrees);
  writer.write_polygons(shape);
  if (format == Format::gpkg) writer.write_isolated(shape);
  return writer.files();
}

std::vector<OgrFile> ogr_groups(Format format, const NamedShapes& groups) {
  OgrWriter writer(format, groups.crs, groups.degrees);
  writer.write_groups(groups);
  return writer.files();
}

std::vector<OgrFile> ogr_triangles(Format format, const TriangleTable& triangles) {
  OgrWriter writer(format, triangles.crs, triangles.degrees);
  writer.write_triangles(triangles);
  return writer.files();
}

std::vector<OgrFile> ogr_isolated(Format format, const Shape& shape) {
  OgrWriter writer(format, shape.crs, shape.degrees);
  writer.write_isolated(shape);
  return writer.files();
}

}  // namespace rbpa::app
