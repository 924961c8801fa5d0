#include <unistd.h>

#include <cmath>
#include <cstring>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/ogr/gdal.h"
#include "io/ogr/ogr.h"

namespace rbpa::app {
namespace {

const char* driver_of(ShapeFormat format) {
  if (format == ShapeFormat::gpkg) return "GPKG";
  return format == ShapeFormat::fgb ? "FlatGeobuf" : "ESRI Shapefile";
}

/// A set of files that GDAL writes into memory: whole files are what is written to a disk.
class OgrWriter {
 public:
  OgrWriter(ShapeFormat format, const Shape& shape) : format_(format), shape_(shape), path_(path_of(format)) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_of(format));
    if (driver == nullptr) fail(std::string("this GDAL has no driver ") + driver_of(format));
    dataset_.reset(driver->Create(path_.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!dataset_) fail(gdal_.reason());
    // One for all features: a database would make one of each.
    in_transaction_ = dataset_->TestCapability(ODsCTransactions) != 0 && dataset_->StartTransaction() == OGRERR_NONE;
    if (!shape.crs) return;
    system_.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);  // x is a longitude, whatever EPSG says
    if (system_.SetFromUserInput(shape.crs->text().c_str()) != OGRERR_NONE)
      fail("--crs " + shape.crs->text() + ": " + gdal_.reason());
  }
  ~OgrWriter() {
    dataset_.reset();
    for (const std::string& ending : ogr_endings(format_)) VSIUnlink(with(ending).c_str());
  }
  OgrWriter(const OgrWriter&) = delete;
  OgrWriter& operator=(const OgrWriter&) = delete;

  void write_polygons() {
    OGRLayer& layer = create_layer("polygons", wkbPolygon);
    for (const char* name : {"number", "holes", "points"}) add_field(layer, name, OFTInteger64);
    for (const char* name : {"area", "perimeter"}) add_field(layer, name, OFTReal);
    const std::vector<std::size_t> points = points_in_polygons(shape_);
    for (std::size_t i = 0; i < shape_.polygons.size(); ++i) {
      const Polygon& polygon = shape_.polygons[i];
      OGRFeature feature(layer.GetLayerDefn());
      set(feature, "number", i + 1);
      set(feature, "holes", polygon.holes.size());
      set(feature, "points", points[i]);
      if (std::isfinite(polygon.area)) feature.SetField("area", polygon.area);
      if (std::isfinite(polygon.perimeter)) feature.SetField("perimeter", polygon.perimeter);
      OGRPolygon geometry;
      add_ring(geometry, polygon.shell);
      for (const Ring& hole : polygon.holes) add_ring(geometry, hole);
      add(layer, feature, geometry, i);
    }
  }

  void write_isolated() {
    OGRLayer& layer = create_layer("isolated", wkbPoint);
    add_field(layer, "index", OFTInteger64);
    for (std::size_t i = 0; i < shape_.points.size(); ++i) {
      if (shape_.polygon_of[i]) continue;
      OGRFeature feature(layer.GetLayerDefn());
      set(feature, "index", i);
      const OGRPoint geometry(shape_.points[i].x, shape_.points[i].y);
      add(layer, feature, geometry, i);
    }
  }

  std::vector<OgrFile> files() {
    if (in_transaction_ && dataset_->CommitTransaction() != OGRERR_NONE) fail(gdal_.reason());
    dataset_.reset();  // writes what is left
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
  /// A name of its own among the files in memory of this process.
  static std::string path_of(ShapeFormat format) {
    static int count = 0;
    return "/vsimem/rbpa-" + std::to_string(getpid()) + "-" + std::to_string(++count) + "." +
           ogr_endings(format).front();
  }
  std::string with(const std::string& ending) const { return path_.substr(0, path_.rfind('.') + 1) + ending; }

  [[noreturn]] void fail(const std::string& why) const {
    throw Failure(std::string("cannot write ") + driver_of(format_) + ": " + why);
  }

  OGRLayer& create_layer(const char* name, OGRwkbGeometryType type) {
    OGRLayer* layer = dataset_->CreateLayer(name, shape_.crs ? &system_ : nullptr, type, nullptr);
    if (layer == nullptr) fail(gdal_.reason());
    return *layer;
  }
  void add_field(OGRLayer& layer, const char* name, OGRFieldType type) const {
    OGRFieldDefn field(name, type);
    if (layer.CreateField(&field) != OGRERR_NONE) fail(gdal_.reason());
  }
  static void set(OGRFeature& feature, const char* name, std::size_t value) {
    feature.SetField(name, static_cast<GIntBig>(value));
  }
  void add_ring(OGRPolygon& polygon, const Ring& ring) const {
    auto line = std::make_unique<OGRLinearRing>();
    for (const std::uint32_t i : ring.points) line->addPoint(shape_.points[i].x, shape_.points[i].y);
    line->addPoint(shape_.points[ring.points.front()].x, shape_.points[ring.points.front()].y);
    polygon.addRingDirectly(line.release());
  }
  void add(OGRLayer& layer, OGRFeature& feature, const OGRGeometry& geometry, std::size_t index) const {
    if (index % 1024 == 0) stop_if_interrupted();
    feature.SetGeometry(&geometry);
    if (layer.CreateFeature(&feature) != OGRERR_NONE) fail(gdal_.reason());
  }

  Gdal gdal_;
  ShapeFormat format_;
  const Shape& shape_;
  std::string path_;
  OGRSpatialReference system_;
  GDALDatasetUniquePtr dataset_;
  bool in_transaction_ = false;
};

}  // namespace

std::vector<OgrFile> ogr_polygons(ShapeFormat format, const Shape& shape) {
  OgrWriter writer(format, shape);
  writer.write_polygons();
  if (format == ShapeFormat::gpkg) writer.write_isolated();
  return writer.files();
}

std::vector<OgrFile> ogr_isolated(ShapeFormat format, const Shape& shape) {
  OgrWriter writer(format, shape);
  writer.write_isolated();
  return writer.files();
}

}  // namespace rbpa::app
