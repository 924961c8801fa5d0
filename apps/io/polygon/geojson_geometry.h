// What: collects the coordinates of one geometry of GeoJSON from the events of a parser.
// Law:  a geometry is refused unless its brackets have the depth of its kind. The closing points of rings are removed.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "io/point_file.h"
#include "io/polygon/polygon_file.h"

namespace rbpa::app {

struct GeoJsonKind {
  std::string_view name;
  int depth;            ///< number of brackets around a coordinate
  bool points = false;  ///< Point or MultiPoint
  bool rings = false;   ///< the innermost lists are rings
};
inline constexpr GeoJsonKind geojson_kinds[] = {{"Point", 1, true},          {"MultiPoint", 2, true},
                                                {"LineString", 2},           {"MultiLineString", 3},
                                                {"Polygon", 3, false, true}, {"MultiPolygon", 4, false, true}};

/// Collects the coordinates of a geometry. The type of the geometry may follow its coordinates. open(), add() and
/// close() return a fault as text, or null.
class GeoJsonGeometry {
 public:
  /// `first` is the number of points before this geometry.
  explicit GeoJsonGeometry(std::size_t first) : first_(first) {}

  const char* open() {
    constexpr int deepest = 4;
    if (coordinates_ > 0) return "a list in a position";
    if (open_ == deepest) return "lists nested five deep";
    ++open_;
    return nullptr;
  }

  const char* add(double coordinate) {
    if (open_ == 0) return "a number in place of a list";
    if (coordinates_ < position_.size()) position_[coordinates_] = coordinate;
    ++coordinates_;
    return nullptr;
  }

  const char* close(PointFile& file) {
    if (coordinates_ == 1) return "a position of one number";
    if (coordinates_ > 0) {
      if (depth_ != 0 && depth_ != open_) return "positions nested at different depths";
      depth_ = open_;
      file.points.push_back({position_[0], position_[1]});
      file.z.push_back(coordinates_ > 2 ? position_[2] : std::numeric_limits<double>::quiet_NaN());
      if (coordinates_ > 2) file.heights.take(position_[2]);
      coordinates_ = 0;
    } else if (depth_ == open_ + 1) {
      ends_.push_back(file.points.size());
    } else if (depth_ == open_ + 2) {
      lists_.push_back(ends_.size());
    }
    --open_;
    return nullptr;
  }

  /// Returns the number of lists around the coordinates of a point; 0 if there is no point.
  int depth() const { return depth_; }
  /// Removes the closing points of rings, lists lines and rings in the file, and appends the polygons of the rings to
  /// `polygons` unless that is null.
  /// Returns false, and changes nothing, if the depth of the brackets is not kind.depth.
  bool finish(const GeoJsonKind& kind, PointFile& file, PolygonFile* polygons) {
    if (depth_ != 0 && depth_ != kind.depth) return false;
    if (kind.points) return true;
    if (kind.rings) remove_closing_points(file);
    std::size_t begin = first_;
    for (const std::size_t end : ends_) file.lines.push_back({std::exchange(begin, end), end, kind.rings});
    if (polygons == nullptr || !kind.rings) return true;
    std::size_t ring = 0, at = first_;
    for (const std::size_t last : lists_) {
      if (ring == last) continue;
      polygons->polygons.emplace_back();
      for (bool is_shell = true; ring < last; is_shell = false) {
        polygons->add_ring(at, ends_[ring], is_shell);
        at = ends_[ring++];
      }
    }
    return true;
  }

 private:
  void remove_closing_points(PointFile& file) {
    std::vector<Point>& points = file.points;
    std::size_t begin = first_, kept = first_;
    for (std::size_t& end : ends_) {
      const std::size_t next = end;
      if (end > begin + 1 && points[end - 1] == points[begin]) --end;
      for (; begin < end; ++begin, ++kept) {
        points[kept] = points[begin];
        file.z[kept] = file.z[begin];
      }
      begin = next;
      end = kept;
    }
    points.resize(kept);
    file.z.resize(kept);
  }

  std::size_t first_;
  int open_ = 0;                 // number of open brackets
  int depth_ = 0;                // depth of the positions; 0: there is none yet
  std::size_t coordinates_ = 0;  // number of coordinates of the current position
  std::array<double, 3> position_{};
  std::vector<std::size_t> ends_ = {};   // end of each innermost list, as the number of points before it
  std::vector<std::size_t> lists_ = {};  // end of each list of innermost lists, as the number of ends_ before it
};

}  // namespace rbpa::app
