#include "io/polygon/ogr.h"
#include "io/number.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <dlfcn.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>
#include <unistd.h>

#include <cmath>
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

/// Returns the function of GDAL of that name. Loads GDAL's library at the first call, as it brings a hundred other
/// libraries, and to load them takes longer than most runs of a program. Throws WrongUsage if there is no such library.
void* gdal_function(const char* name) {
  static void* const library = dlopen(RBPA_GDAL_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  void* const function = library == nullptr ? nullptr : dlsym(library, name);
  if (function == nullptr) {
    const char* const why = dlerror();  // null if this is not the first call
    throw WrongUsage("found a format of GDAL, expected its library: " +
                     std::string(why == nullptr ? RBPA_GDAL_LIBRARY : why));
  }
  return function;
}

/// A function of GDAL's C interface, with its type.
#define GDAL(name)                                                                          \
  ([] {                                                                                     \
    static const auto function = reinterpret_cast<decltype(&::name)>(gdal_function(#name)); \
    return function;                                                                        \
  }())

/// Registers GDAL's drivers, and keeps GDAL from printing while this object exists.
class GdalErrors {
 public:
  GdalErrors() {
    static const bool drivers_are_known = (GDAL(GDALAllRegister)(), true);
    static_cast<void>(drivers_are_known);
    GDAL(CPLPushErrorHandler)(GDAL(CPLQuietErrorHandler));
    GDAL(CPLErrorReset)();
  }
  ~GdalErrors() { GDAL(CPLPopErrorHandler)(); }
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  /// Returns whether a call of GDAL has failed since this object was made.
  bool have_come() const { return GDAL(CPLGetLastErrorType)() >= CE_Failure; }
  /// Returns GDAL's message about the last failure.
  std::string reason() const {
    const std::string text = GDAL(CPLGetLastErrorMsg)();
    return text.empty() ? "nothing that GDAL knows" : text;
  }
};

// Objects of GDAL that belong to the program.
struct FreeDataset {
  void operator()(GDALDatasetH dataset) const { GDAL(GDALClose)(dataset); }
};
struct FreeFeature {
  void operator()(OGRFeatureH feature) const { GDAL(OGR_F_Destroy)(feature); }
};
struct FreeField {
  void operator()(OGRFieldDefnH field) const { GDAL(OGR_Fld_Destroy)(field); }
};
struct FreeGeometry {
  void operator()(OGRGeometryH geometry) const { GDAL(OGR_G_DestroyGeometry)(geometry); }
};
struct FreeSystem {
  void operator()(OGRSpatialReferenceH system) const { GDAL(OSRDestroySpatialReference)(system); }
};
using Dataset = std::unique_ptr<void, FreeDataset>;
using Feature = std::unique_ptr<void, FreeFeature>;
using Field = std::unique_ptr<void, FreeField>;
using Geometry = std::unique_ptr<void, FreeGeometry>;
using System = std::unique_ptr<void, FreeSystem>;

Feature feature_of(OGRLayerH layer) { return Feature(GDAL(OGR_F_Create)(GDAL(OGR_L_GetLayerDefn)(layer))); }
Geometry geometry_of(OGRwkbGeometryType type) { return Geometry(GDAL(OGR_G_CreateGeometry)(type)); }

class OgrReader {
 public:
  OgrReader(const std::string& source, bool vertices) : source_(source), vertices_(vertices) {}

  PointFile read(const std::optional<std::string>& layer_name) {
    constexpr unsigned how = GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR;
    const Dataset dataset(GDAL(GDALOpenEx)(source_.c_str(), how, nullptr, nullptr, nullptr));
    if (!dataset) throw BadInput(source_ + ": GDAL cannot read it: " + shown(errors_.reason()));
    const OGRLayerH layer = find_layer(dataset.get(), layer_name);
    take_crs(layer);
    GDAL(OGR_L_ResetReading)(layer);
    while (const Feature feature{GDAL(OGR_L_GetNextFeature)(layer)}) {
      if (features_++ % 1024 == 0) stop_if_interrupted();
      const OGRGeometryH geometry = GDAL(OGR_F_GetGeometryRef)(feature.get());
      geometry == nullptr ? static_cast<void>(++without_geometry_) : take(geometry);
    }
    // Refuse a file that can be read in part only.
    if (errors_.have_come())
      throw BadInput(source_ + ": GDAL cannot read all of it: " + shown(errors_.reason()) +
                     " (ogr2ogr -skipfailures copies what it can read)");
    const GIntBig announced = GDAL(OGR_L_GetFeatureCount)(layer, FALSE);  // below 0: not known without counting
    if (announced >= 0 && static_cast<std::size_t>(announced) != features_)
      bad_input(source_, counted(features_, "feature"), std::to_string(announced) + " as the file says");
    if (without_geometry_ > 0) file_.warnings.push_back(counted(without_geometry_, "feature") + " without a geometry");
    return std::move(file_);
  }

 private:
  OGRLayerH find_layer(GDALDatasetH dataset, const std::optional<std::string>& name) const {
    std::string names;
    const int count = GDAL(GDALDatasetGetLayerCount)(dataset);
    for (int i = 0; i < count; ++i) {
      const OGRLayerH layer = GDAL(GDALDatasetGetLayer)(dataset, i);
      const std::string its_name = GDAL(OGR_L_GetName)(layer);
      if (name ? *name == its_name : count == 1) return layer;
      names += (names.empty() ? "" : ", ") + its_name;
    }
    bad_input(source_, names.empty() ? "no layer" : "the layers " + names,
              name ? "one called " + in_quotes(*name) : "--layer with the name of one");
  }

  void take_crs(OGRLayerH layer) {
    const OGRSpatialReferenceH whole = GDAL(OGR_L_GetSpatialRef)(layer);
    const char* const name = whole == nullptr ? nullptr : GDAL(OSRGetName)(whole);
    if (name == nullptr) return;  // none, or an empty one
    const System system(GDAL(OSRClone)(whole));
    if (GDAL(OSRIsCompound)(system.get()) != 0) GDAL(OSRStripVertical)(system.get());
    const char* authority = GDAL(OSRGetAuthorityName)(system.get(), nullptr);
    const char* code = GDAL(OSRGetAuthorityCode)(system.get(), nullptr);
    file_.degrees = GDAL(OSRIsGeographic)(system.get()) != 0;
    if (authority != nullptr && code != nullptr && GDAL(OSRIsVertical)(system.get()) == 0)
      file_.crs = Crs{.authority = authority, .code = code, .degrees = file_.degrees};
    else
      file_.warnings.push_back("the system of coordinates, " + in_quotes(name) +
                               ", has no code of the plane and is not carried over (--crs EPSG:CODE names it)");
  }

  /// Takes point i of a point or of a line.
  void take_point(OGRGeometryH geometry, int i) {
    const Point point{GDAL(OGR_G_GetX)(geometry, i), GDAL(OGR_G_GetY)(geometry, i)};
    if (!is_finite(point))
      bad_input(source_ + ": feature " + std::to_string(features_),
                "the point (" + text_of(point.x) + ", " + text_of(point.y) + ")", "finite coordinates");
    const bool has_z = GDAL(OGR_G_Is3D)(geometry) != 0;
    const double z = has_z ? GDAL(OGR_G_GetZ)(geometry, i) : std::numeric_limits<double>::quiet_NaN();
    file_.points.push_back(point);
    file_.z.push_back(z);
    if (has_z) file_.heights.take(z);
  }

  void take_line(OGRGeometryH line, bool ring) {
    const auto x = GDAL(OGR_G_GetX);
    const auto y = GDAL(OGR_G_GetY);
    int count = GDAL(OGR_G_GetPointCount)(line);
    const bool closes = count > 1 && x(line, 0) == x(line, count - 1) && y(line, 0) == y(line, count - 1);
    if (ring && closes) --count;
    const std::size_t first = file_.points.size();
    for (int i = 0; i < count; ++i) take_point(line, i);
    file_.lines.push_back({first, file_.points.size(), ring});
  }

  void take(OGRGeometryH geometry) {
    const OGRwkbGeometryType type = GDAL(OGR_GT_Flatten)(GDAL(OGR_G_GetGeometryType)(geometry));
    if (type == wkbPoint) {
      if (GDAL(OGR_G_IsEmpty)(geometry) == 0) take_point(geometry, 0);
      return;
    }
    const int parts = GDAL(OGR_G_GetGeometryCount)(geometry);
    const auto is_a = [&](OGRwkbGeometryType kind) { return GDAL(OGR_GT_IsSubClassOf)(type, kind) != 0; };
    if (is_a(wkbGeometryCollection)) {
      for (int i = 0; i < parts; ++i) take(GDAL(OGR_G_GetGeometryRef)(geometry, i));
      return;
    }
    const char* const name = GDAL(OGR_G_GetGeometryName)(geometry);
    if (!vertices_)
      bad_input(source_ + ": feature " + std::to_string(features_), name,
                "POINT or MULTIPOINT (--vertices takes the vertices of lines and polygons)");
    if (is_a(wkbLineString)) return take_line(geometry, false);
    if (!is_a(wkbPolygon))
      bad_input(source_ + ": feature " + std::to_string(features_), name,
                "points, lines or polygons (ogr2ogr -nlt CONVERT_TO_LINEAR makes them)");
    for (int i = 0; i < parts; ++i) take_line(GDAL(OGR_G_GetGeometryRef)(geometry, i), true);
  }

  GdalErrors errors_;
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
    const GDALDriverH driver = GDAL(GDALGetDriverByName)(driver_of(format));
    if (driver == nullptr) fail(std::string("this GDAL has no driver ") + driver_of(format));
    dataset_.reset(GDAL(GDALCreate)(driver, path_.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!dataset_) fail(errors_.reason());
    // Use one transaction for all features: a database would otherwise make one for each.
    in_transaction_ = GDAL(GDALDatasetTestCapability)(dataset_.get(), ODsCTransactions) != 0 &&
                      GDAL(GDALDatasetStartTransaction)(dataset_.get(), FALSE) == OGRERR_NONE;
    const bool is_cartesian = !crs && !degrees && format == Format::gpkg;
    if (!crs && !is_cartesian) return;
    system_.reset(GDAL(OSRNewSpatialReference)(nullptr));
    if (is_cartesian)  // GDAL writes its number in the standard, -1
      GDAL(OSRSetLocalCS)(system_.get(), "Undefined Cartesian SRS");
    if (!crs) return;
    // x is the longitude, also where EPSG orders latitude first.
    GDAL(OSRSetAxisMappingStrategy)(system_.get(), OAMS_TRADITIONAL_GIS_ORDER);
    if (GDAL(OSRSetFromUserInput)(system_.get(), crs->text().c_str()) != OGRERR_NONE)
      fail("--crs " + crs->text() + ": " + errors_.reason());
  }
  ~OgrWriter() {
    dataset_.reset();
    for (const std::string& ending : ogr_endings(format_)) GDAL(VSIUnlink)(with(ending).c_str());
  }
  OgrWriter(const OgrWriter&) = delete;
  OgrWriter& operator=(const OgrWriter&) = delete;

  void write_polygons(const Shape& shape) {
    const OGRLayerH layer = create_layer("polygons", wkbPolygon);
    for (const char* name : {"number", "holes", "points"}) add_field(layer, name, OFTInteger64);
    for (const char* name : {"area", "perimeter"}) add_field(layer, name, OFTReal);
    add_attributes(layer, shape.summaries);
    const std::vector<std::size_t> points = points_in_polygons(shape);
    for (std::size_t i = 0; i < shape.polygons.size(); ++i) {
      const Polygon& polygon = shape.polygons[i];
      const Feature feature = feature_of(layer);
      set(feature.get(), "number", i + 1);
      set(feature.get(), "holes", polygon.holes.size());
      set(feature.get(), "points", points[i]);
      set(feature.get(), "area", polygon.area);
      set(feature.get(), "perimeter", polygon.perimeter);
      set(feature.get(), shape.summaries, i);
      add(layer, feature.get(), polygon_of(polygon, shape.points), i);
    }
  }

  void write_isolated(const Shape& shape) {
    const OGRLayerH layer = create_layer("isolated", wkbPoint);
    add_field(layer, "index", OFTInteger64);
    const std::vector<Attribute> fields =
        attributes_of(shape.fields, {"index", GDAL(OGR_L_GetFIDColumn)(layer), GDAL(OGR_L_GetGeometryColumn)(layer)});
    add_attributes(layer, fields);
    for (std::size_t i = 0; i < shape.polygon_of.size(); ++i) {
      if (shape.polygon_of[i]) continue;
      const Feature feature = feature_of(layer);
      set(feature.get(), "index", std::size_t{renumbered(static_cast<std::uint32_t>(i), shape.index)});
      set(feature.get(), fields, i);
      Geometry geometry = geometry_of(wkbPoint);
      GDAL(OGR_G_AddPoint_2D)(geometry.get(), shape.points[i].x, shape.points[i].y);
      add(layer, feature.get(), std::move(geometry), i);
    }
  }

  void write_groups(const NamedShapes& groups) {
    const OGRLayerH layer = create_layer("groups", wkbMultiPolygon);
    // Use real numbers: names that are numbers need not be integers.
    add_field(layer, "group", groups.are_numbers ? OFTReal : OFTString);
    for (const char* name : {"points", "polygons"}) add_field(layer, name, OFTInteger64);
    for (const char* name : {"alpha", "area", "perimeter"}) add_field(layer, name, OFTReal);
    add_field(layer, "problem", OFTString);
    add_attributes(layer, groups.attributes);
    const std::vector<std::string_view> problems = problems_of(groups);
    for (std::size_t g = 0; g < groups.names.size(); ++g) {
      const std::uint64_t first = groups.shapes.polygon_begin[g], last = groups.shapes.polygon_begin[g + 1];
      const Feature feature = feature_of(layer);
      set(feature.get(), "group", groups.names[g]);
      set(feature.get(), "points", groups.sizes[g]);
      set(feature.get(), "polygons", last - first);
      set(feature.get(), "alpha", groups.shapes.alphas[g]);
      set(feature.get(), "area", groups.shapes.totals[g].area);
      set(feature.get(), "perimeter", groups.shapes.totals[g].perimeter);
      set(feature.get(), groups.attributes, g);
      if (!problems[g].empty()) set(feature.get(), "problem", std::string(problems[g]));
      Geometry geometry = geometry_of(wkbMultiPolygon);
      for (std::uint64_t i = first; i < last; ++i)
        add_part(geometry, polygon_of(groups.shapes.polygons[i], groups.points));
      add(layer, feature.get(), std::move(geometry), g);
    }
  }

  void write_triangles(const TriangleTable& triangles) {
    const OGRLayerH layer = create_layer("triangles", triangles.has_z ? wkbPolygon25D : wkbPolygon);
    add_field(layer, "number", OFTInteger64);
    for (const TriangleAttribute& attribute : triangles.attributes)
      add_field(layer, attribute.name.c_str(), attribute.text ? OFTString : OFTReal);
    for (std::size_t i = 0; i < triangles.count; ++i) {
      const Feature feature = feature_of(layer);
      set(feature.get(), "number", i + 1);
      for (std::size_t k = 0; k < triangles.attributes.size(); ++k) {
        const TriangleAttribute& attribute = triangles.attributes[k];
        const int place = static_cast<int>(k) + 1;  // by index, as GDAL may have shortened the name
        if (attribute.text)
          GDAL(OGR_F_SetFieldString)(feature.get(), place, attribute.text(i).c_str());
        else if (const double value = attribute.number(i); std::isfinite(value))
          GDAL(OGR_F_SetFieldDouble)(feature.get(), place, value);
      }
      Geometry geometry = geometry_of(wkbPolygon), ring = geometry_of(wkbLinearRing);
      const auto corners = triangles.corners(i);
      for (const std::size_t k : {0U, 1U, 2U, 0U})
        triangles.has_z ? GDAL(OGR_G_AddPoint)(ring.get(), corners[k].x, corners[k].y, corners[k].z)
                        : GDAL(OGR_G_AddPoint_2D)(ring.get(), corners[k].x, corners[k].y);
      add_part(geometry, std::move(ring));
      add(layer, feature.get(), std::move(geometry), i);
    }
  }

  std::vector<OgrFile> files() {
    if (in_transaction_ && GDAL(GDALDatasetCommitTransaction)(dataset_.get()) != OGRERR_NONE) fail(errors_.reason());
    dataset_.reset();  // writes the rest
    if (errors_.have_come()) fail(errors_.reason());
    std::vector<OgrFile> files;
    for (const std::string& ending : ogr_endings(format_)) {
      vsi_l_offset size = 0;
      const GByte* bytes = GDAL(VSIGetMemFileBuffer)(with(ending).c_str(), &size, 0);
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

  OGRLayerH create_layer(const char* name, OGRwkbGeometryType type) {
    const OGRLayerH layer = GDAL(GDALDatasetCreateLayer)(dataset_.get(), name, system_.get(), type, nullptr);
    if (layer == nullptr) fail(errors_.reason());
    return layer;
  }
  void add_field(OGRLayerH layer, const char* name, OGRFieldType type) const {
    const Field field(GDAL(OGR_Fld_Create)(name, type));
    if (GDAL(OGR_L_CreateField)(layer, field.get(), TRUE) != OGRERR_NONE) fail(errors_.reason());
  }
  /// Adds a field for each attribute. Unsigned integers of 64 bits, which OGR does not have, become texts.
  void add_attributes(OGRLayerH layer, std::span<const Attribute> attributes) const {
    for (const Attribute& attribute : attributes) {
      const PointColumn& column = *attribute.column;
      const bool is_text = column.is_text || column.type == Scalar::uint64;
      add_field(layer, attribute.name.c_str(), is_text ? OFTString : is_integer(column.type) ? OFTInteger64 : OFTReal);
    }
  }
  /// Set the last fields, which are `attributes`, or one by name; a number that is not finite is null, as in JSON. GDAL
  /// converts a text to the type of the field.
  static void set(OGRFeatureH feature, std::span<const Attribute> attributes, std::size_t index) {
    int place = GDAL(OGR_F_GetFieldCount)(feature) - static_cast<int>(attributes.size());
    for (const Attribute& attribute : attributes) {
      attribute.with_value(index, [&](const auto& value) {
        if constexpr (requires { value.c_str(); })
          GDAL(OGR_F_SetFieldString)(feature, place, value.c_str());
        else if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(value)>>)
          GDAL(OGR_F_SetFieldString)(feature, place, std::to_string(value).c_str());
        else if (std::isfinite(value))
          GDAL(OGR_F_SetFieldDouble)(feature, place, static_cast<double>(value));
      });
      ++place;
    }
  }
  static int place_of(OGRFeatureH feature, const char* name) { return GDAL(OGR_F_GetFieldIndex)(feature, name); }
  static void set(OGRFeatureH feature, const char* name, const std::string& value) {
    GDAL(OGR_F_SetFieldString)(feature, place_of(feature, name), value.c_str());
  }
  static void set(OGRFeatureH feature, const char* name, std::size_t value) {
    GDAL(OGR_F_SetFieldInteger64)(feature, place_of(feature, name), static_cast<GIntBig>(value));
  }
  static void set(OGRFeatureH feature, const char* name, double value) {
    if (std::isfinite(value)) GDAL(OGR_F_SetFieldDouble)(feature, place_of(feature, name), value);
  }
  static void add_part(const Geometry& whole, Geometry part) {
    GDAL(OGR_G_AddGeometryDirectly)(whole.get(), part.release());
  }
  static Geometry polygon_of(const Polygon& polygon, std::span<const Point> points) {
    Geometry geometry = geometry_of(wkbPolygon);
    const auto add_ring = [&](const Ring& ring) {
      Geometry line = geometry_of(wkbLinearRing);
      const auto add_point = [&](std::uint32_t i) { GDAL(OGR_G_AddPoint_2D)(line.get(), points[i].x, points[i].y); };
      for (const std::uint32_t i : ring.points) add_point(i);
      add_point(ring.points.front());
      add_part(geometry, std::move(line));
    };
    add_ring(polygon.shell);
    for (const Ring& hole : polygon.holes) add_ring(hole);
    return geometry;
  }
  void add(OGRLayerH layer, OGRFeatureH feature, Geometry geometry, std::size_t index) const {
    if (index % 1024 == 0) stop_if_interrupted();
    if (GDAL(OGR_G_IsEmpty)(geometry.get()) == 0) GDAL(OGR_F_SetGeometryDirectly)(feature, geometry.release());
    if (GDAL(OGR_L_CreateFeature)(layer, feature) != OGRERR_NONE) fail(errors_.reason());
  }

  GdalErrors errors_;
  Format format_;
  std::string path_;
  System system_;  // null if the layers have none
  Dataset dataset_;
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
