#include "io/gis/geojson_geometry.h"

#include <utility>

namespace rbpa::app {

std::optional<GeoJsonKind> geojson_kind(std::string_view type) {
  constexpr std::pair<std::string_view, GeoJsonKind> known[] = {
      {"Point", {1, true, false}},       {"MultiPoint", {2, true, false}},
      {"LineString", {2, false, false}}, {"MultiLineString", {3, false, false}},
      {"Polygon", {3, false, true}},     {"MultiPolygon", {4, false, true}}};
  for (const auto& [name, kind] : known)
    if (type == name) return kind;
  return std::nullopt;
}

const char* GeoJsonGeometry::open() {
  constexpr int deepest = 4;
  if (coordinates_ > 0) return "a list among numbers";
  if (open_ == deepest) return "five brackets around each other";
  ++open_;
  return nullptr;
}

const char* GeoJsonGeometry::add(double coordinate) {
  if (open_ == 0) return "a number";
  if (coordinates_ < position_.size()) position_[coordinates_] = coordinate;
  ++coordinates_;
  return nullptr;
}

const char* GeoJsonGeometry::close(std::vector<Point>& points, Heights& heights) {
  if (coordinates_ == 1) return "one number";
  if (coordinates_ > 0) {
    if (depth_ != 0 && depth_ != open_) return "positions in different brackets";
    depth_ = open_;
    points.push_back({position_[0], position_[1]});
    if (coordinates_ > 2) heights.take(position_[2]);
    coordinates_ = 0;
  } else if (depth_ == open_ + 1) {
    ends_.push_back(points.size());
  } else if (depth_ == open_ + 2) {
    lists_.push_back(ends_.size());
  }
  --open_;
  return nullptr;
}

bool GeoJsonGeometry::finish(const GeoJsonKind& kind, std::vector<Point>& points,
                             std::vector<Polygon>* polygons) const {
  if (depth_ != 0 && depth_ != kind.depth) return false;
  if (!kind.rings) return true;
  std::size_t begin = first_, kept = first_, ring = 0;
  std::vector<std::size_t> kept_ends;
  for (std::size_t end : ends_) {
    const std::size_t next = end;
    if (end > begin + 1 && points[end - 1] == points[begin]) --end;
    for (; begin < end; ++begin) points[kept++] = points[begin];
    begin = next;
    kept_ends.push_back(kept);
  }
  points.resize(kept);
  if (polygons == nullptr) return true;
  std::size_t at = first_;
  for (const std::size_t last : lists_) {
    if (ring == last) continue;
    Polygon& polygon = polygons->emplace_back();
    for (bool is_shell = true; ring < last; ++ring, is_shell = false) {
      Ring& made = is_shell ? polygon.shell : polygon.holes.emplace_back();
      for (; at < kept_ends[ring]; ++at) made.points.push_back(static_cast<std::uint32_t>(at));
    }
  }
  return true;
}

}  // namespace rbpa::app
