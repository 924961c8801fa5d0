#include <algorithm>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/ogr/gdal.h"
#include "io/ogr/ogr.h"

namespace rbpa::app {
namespace {

class OgrReader {
 public:
  OgrReader(const std::string& source, bool vertices) : source_(source), vertices_(vertices) {}

  PointFile read(const std::optional<std::string>& layer_name) {
    constexpr unsigned how = GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR;
    const GDALDatasetUniquePtr dataset(GDALDataset::Open(source_.c_str(), how));
    if (!dataset) bad_input(source_, shown(gdal_.reason()), "a vector file that GDAL reads");
    OGRLayer& layer = find_layer(*dataset, layer_name);
    take_crs(layer);
    layer.ResetReading();
    while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
      if (features_++ % 1024 == 0) stop_if_interrupted();
      const OGRGeometry* geometry = feature->GetGeometryRef();
      geometry == nullptr ? static_cast<void>(++without_geometry_) : take(*geometry);
    }
    // What is half read is no answer.
    if (gdal_.has_failed()) bad_input(source_, shown(gdal_.reason()), "a whole vector file");
    constexpr int if_known = 0;
    const GIntBig announced = layer.GetFeatureCount(if_known);
    if (announced >= 0 && static_cast<std::size_t>(announced) != features_)
      bad_input(source_, counted(features_, "feature"), std::to_string(announced) + " as the file says");
    if (without_geometry_ > 0) file_.remarks.push_back(counted(without_geometry_, "feature") + " without a geometry");
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
    const OGRSpatialReference* system = const_cast<OGRLayer&>(layer).GetSpatialRef();  // which changes nothing
    if (system == nullptr || system->IsEmpty()) return;
    const char* authority = system->GetAuthorityName(nullptr);
    const char* code = system->GetAuthorityCode(nullptr);
    file_.degrees = system->IsGeographic() != 0;
    if (authority != nullptr && code != nullptr)
      file_.crs = Crs{.authority = authority, .code = code, .degrees = file_.degrees};
    else
      file_.remarks.push_back("the system of coordinates, " + in_quotes(system->GetName()) +
                              ", has no code and is not carried over (--crs says one)");
  }

  void take(const OGRPoint& p) {
    if (p.IsEmpty()) return;
    const Point point{p.getX(), p.getY()};
    if (!is_finite(point))
      bad_input(source_ + ": feature " + std::to_string(features_), "a coordinate that is not finite", "numbers");
    file_.points.push_back(point);
  }

  void take(const OGRSimpleCurve& line, bool ring) {
    int count = line.getNumPoints();
    const bool closes = count > 1 && line.getX(0) == line.getX(count - 1) && line.getY(0) == line.getY(count - 1);
    if (ring && closes) --count;
    for (int i = 0; i < count; ++i) take(OGRPoint(line.getX(i), line.getY(i)));
  }

  void take(const OGRGeometry& geometry) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    const bool is_collection = OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0;
    if (type == wkbPoint) return take(*geometry.toPoint());
    if (is_collection) {
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

}  // namespace rbpa::app
