#include "io/polygon/geojson.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/text/lines.h"

namespace rbpa::app {

namespace {

struct GeoJsonKind {
  std::string_view name;
  int depth;            ///< brackets around a position, its own included
  bool points = false;  ///< Point or MultiPoint
  bool rings = false;   ///< the lists innermost end where they begin
};
constexpr GeoJsonKind geojson_kinds[] = {{"Point", 1, true},          {"MultiPoint", 2, true},
                                         {"LineString", 2},           {"MultiLineString", 3},
                                         {"Polygon", 3, false, true}, {"MultiPolygon", 4, false, true}};

/// The coordinates of a geometry, which may come before its type. Each step returns what is wrong, or null.
class GeoJsonGeometry {
 public:
  /// Its points will follow `first` others.
  explicit GeoJsonGeometry(std::size_t first) : first_(first) {}

  const char* open() {
    constexpr int deepest = 4;
    if (coordinates_ > 0) return "a list among numbers";
    if (open_ == deepest) return "five brackets around each other";
    ++open_;
    return nullptr;
  }

  const char* add(double coordinate) {
    if (open_ == 0) return "a number";
    if (coordinates_ < position_.size()) position_[coordinates_] = coordinate;
    ++coordinates_;
    return nullptr;
  }

  const char* close(PointFile& file) {
    if (coordinates_ == 1) return "one number";
    if (coordinates_ > 0) {
      if (depth_ != 0 && depth_ != open_) return "positions in different brackets";
      depth_ = open_;
      file.points.push_back({position_[0], position_[1]});
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

  /// Takes the points at which rings close away, and appends the polygons that rings make, if they are wanted. False when
  /// positions lay in other brackets than the kind has.
  bool finish(const GeoJsonKind& kind, std::vector<Point>& points, PolygonFile* polygons) {
    if (depth_ != 0 && depth_ != kind.depth) return false;
    if (!kind.rings) return true;
    std::size_t begin = first_, kept = first_;
    for (std::size_t& end : ends_) {
      const std::size_t next = end;
      if (end > begin + 1 && points[end - 1] == points[begin]) --end;
      for (; begin < end; ++begin) points[kept++] = points[begin];
      begin = next;
      end = kept;
    }
    points.resize(kept);
    if (polygons == nullptr) return true;
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
  std::size_t first_;
  int open_ = 0;                 // brackets
  int depth_ = 0;                // of the positions so far; 0: none
  std::size_t coordinates_ = 0;  // in the position that is not at its end
  std::array<double, 3> position_{};
  std::vector<std::size_t> ends_ = {};   // of the innermost lists of positions, as counts of all points
  std::vector<std::size_t> lists_ = {};  // of these, as counts of ends
};

/// The text as nlohmann's parser wants it; how far it has come is seen by others.
class JsonPosition {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  explicit JsonPosition(const char*& at) : at_(&at) {}
  reference operator*() const { return **at_; }
  JsonPosition& operator++() {
    ++*at_;
    return *this;
  }
  friend bool operator==(const JsonPosition& a, const JsonPosition& b) { return *a.at_ == *b.at_; }
  friend bool operator!=(const JsonPosition& a, const JsonPosition& b) { return !(a == b); }

 private:
  const char** at_;
};

/// What the value of a key is.
enum class Slot { ignored, type, coordinates, object, objects, crs, properties };

Slot slot_of(const std::string& key) {
  if (key == "type") return Slot::type;
  if (key == "coordinates") return Slot::coordinates;
  if (key == "geometry") return Slot::object;
  if (key == "features" || key == "geometries") return Slot::objects;
  if (key == "properties") return Slot::properties;
  return key == "crs" ? Slot::crs : Slot::ignored;
}

/// The events of a parser as points. Objects may say what they are behind what is in them.
class Events {
 public:
  /// With `polygons` these are taken, and nothing else.
  Events(std::string_view text, const std::string& name, bool vertices, PolygonFile* polygons = nullptr)
      : begin_(text.data()),
        at_(begin_),
        end_(begin_ + text.size()),
        name_(name),
        vertices_(vertices),
        polygons_(polygons) {}

  PointFile read() {
    if (at_end()) refuse("nothing but blanks", "GeoJSON");
    while (!at_end()) {
      JsonPosition first(at_), last(end_);
      constexpr bool to_the_end = false;  // others may follow
      nlohmann::json::sax_parse(first, last, this, nlohmann::json::input_format_t::json, to_the_end);
    }
    if (without_geometry_ > 0) file_.remarks.push_back(counted(without_geometry_, "feature") + " without a geometry");
    settle_crs();
    return std::move(file_);
  }

  bool null() {
    if (!frames_.empty() && is_in(Slot::object)) ++without_geometry_;
    if (is_in(Slot::crs)) crs_is_unknown_ = true;
    return scalar("null", is_in(Slot::object) || is_in(Slot::crs));
  }
  bool boolean(bool value) { return scalar(value ? "true" : "false", false); }
  bool number_integer(std::int64_t value) {
    // The one integer whose sign is lost.
    const bool negative_zero = value == 0 && at_ - begin_ >= 3 && at_[-3] == '-' && at_[-2] == '0';
    const bool at_the_end = value == 0 && at_ == end_ && at_ - begin_ >= 2 && at_[-2] == '-' && at_[-1] == '0';
    return number(negative_zero || at_the_end ? -0.0 : static_cast<double>(value));
  }
  bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
  bool number_float(double value, const std::string& /*text*/) { return number(value); }
  bool binary(const std::vector<std::uint8_t>& /*value*/) { return true; }

  bool string(const std::string& value) {
    if (inside(Slot::crs) && inner_key_ == "name") crs_name_ = value;
    if (is_in(Slot::type)) frames_.back().type = value;
    return scalar(in_quotes(value), is_in(Slot::type));
  }

  bool key(const std::string& key) {
    if (depth_ > 0) {
      inner_key_ = key;
      return true;
    }
    Frame& frame = frames_.back();
    frame.slot = slot_of(key);
    if (frame.slot != Slot::coordinates) return true;
    if (frame.geometry) refuse("coordinates twice in an object", "once");
    frame.geometry = GeoJsonGeometry(file_.points.size());
    return true;
  }

  bool start_object(std::size_t /*size*/) {
    if (passes_over(+1)) return true;
    if (!frames_.empty()) {
      const Frame& frame = frames_.back();
      if (frame.slot == Slot::crs || is_passed_over(frame.slot)) return pass_over(frame.slot);
      if (frame.slot == Slot::coordinates || frame.slot == Slot::type ||
          (frame.slot == Slot::objects && !frame.in_list))
        refuse("an object", "a " + expected(frame.slot));
    }
    frames_.push_back({.geometries = polygons_ == nullptr ? 0 : polygons_->geometries.size()});
    return true;
  }
  bool end_object() {
    if (passes_over(-1)) return true;
    finish(frames_.back());
    if (polygons_ != nullptr) count_feature(frames_.back(), frames_.size() == 1);
    frames_.pop_back();
    return true;
  }

  bool start_array(std::size_t /*size*/) {
    if (passes_over(+1)) return true;
    if (frames_.empty()) refuse("an array", "a GeoJSON object");
    Frame& frame = frames_.back();
    if (is_passed_over(frame.slot)) return pass_over(Slot::ignored);
    if (frame.slot == Slot::coordinates) return check(frame.geometry->open());
    if (frame.slot != Slot::objects || frame.in_list) refuse("an array", "a " + expected(frame.slot));
    return frame.in_list = true;
  }
  bool end_array() {
    if (passes_over(-1)) return true;
    Frame& frame = frames_.back();
    if (frame.slot == Slot::coordinates) return check(frame.geometry->close(file_));
    frame.in_list = false;
    return true;
  }

  bool parse_error(std::size_t /*position*/, const std::string& token, const nlohmann::detail::exception& error) {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow) refuse(in_quotes(token), "a number within the range of a double (up to 1.8e308)");
    refuse(at_ == end_ ? "the end of the file" : in_quotes(token), "JSON");
  }

 private:
  /// An object of GeoJSON that is not at its end.
  struct Frame {
    std::string type = {};
    Slot slot = Slot::ignored;
    bool in_list = false;  // of Slot::objects
    std::optional<GeoJsonGeometry> geometry = std::nullopt;
    std::size_t geometries = 0;                                // that were read before it
    std::vector<std::pair<std::string, double>> numbers = {};  // its properties
  };

  static bool is_passed_over(Slot slot) { return slot == Slot::ignored || slot == Slot::properties; }

  static std::string expected(Slot slot) {
    if (slot == Slot::type) return "type: a text";
    if (slot == Slot::coordinates) return "list of coordinates";
    return slot == Slot::object || slot == Slot::crs ? "GeoJSON object" : "list of GeoJSON objects";
  }

  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    const std::size_t before = count_line_ends({begin_, static_cast<std::size_t>(at_ - begin_)});
    const bool behind_end = at_ != begin_ && at_[-1] == '\n';  // which the parser has seen already
    bad_input(at_line(name_, before + (behind_end ? 0 : 1)), found, expected);
  }
  bool check(const char* fault) const {
    if (fault != nullptr) refuse(fault, "coordinates: positions of two numbers or more, in lists");
    return true;
  }

  bool at_end() {
    constexpr char record_separator = '\x1E';  // of RFC 8142
    while (at_ != end_ && (is_blank(*at_) || *at_ == '\n' || *at_ == record_separator)) ++at_;
    return at_ == end_;
  }

  bool is_in(Slot slot) const { return depth_ == 0 && !frames_.empty() && frames_.back().slot == slot; }
  bool inside(Slot slot) const { return depth_ > 0 && passed_over_ == slot; }

  /// What follows up to the bracket that closes has no points.
  bool pass_over(Slot slot) {
    passed_over_ = slot;
    depth_ = 1;
    return true;
  }

  /// What begins or ends lies in what is of no interest.
  bool passes_over(int step) {
    if (++events_ % 65536 == 0) stop_if_interrupted();
    if (depth_ == 0) return false;
    depth_ = step > 0 ? depth_ + 1 : depth_ - 1;
    return true;
  }

  /// A value that is neither number, object nor array.
  bool scalar(const std::string& found, bool fits) const {
    if (depth_ > 0) return true;
    if (frames_.empty()) refuse(found, "a GeoJSON object");
    if (!fits && !is_passed_over(frames_.back().slot)) refuse(found, "a " + expected(frames_.back().slot));
    return true;
  }

  bool number(double value) {
    if (inside(Slot::crs) && inner_key_ == "code" && value > 0 && value < 1e9 && value == std::trunc(value))
      crs_name_ = "EPSG:" + std::to_string(static_cast<std::uint64_t>(value));
    if (inside(Slot::properties) && depth_ == 1 && polygons_ != nullptr)
      frames_.back().numbers.emplace_back(inner_key_, value);
    if (is_in(Slot::coordinates)) return check(frames_.back().geometry->add(value));
    return scalar("a number", false);
  }

  /// At the end of an object it is known what it was.
  void finish(Frame& frame) {
    const auto* kind = std::find_if(std::begin(geojson_kinds), std::end(geojson_kinds),
                                    [&](const GeoJsonKind& known) { return known.name == frame.type; });
    if (kind == std::end(geojson_kinds)) {
      constexpr std::string_view others[] = {"FeatureCollection", "Feature", "GeometryCollection"};
      if (std::find(std::begin(others), std::end(others), frame.type) != std::end(others)) {
        if (frame.geometry) refuse("coordinates in a " + frame.type, "a geometry that has them");
        return;
      }
      if (frame.type == "Topology") refuse("TopoJSON", "GeoJSON (ogr2ogr -f GeoJSON points.geojson FILE)");
      refuse(frame.type.empty() ? "an object without a type" : "the type " + in_quotes(frame.type),
             "one of GeoJSON, such as FeatureCollection or MultiPoint");
    }
    if (!frame.geometry) refuse("a " + frame.type + " without coordinates", "some");
    if (polygons_ != nullptr && !kind->rings) refuse("a " + frame.type, "Polygon or MultiPolygon");
    if (polygons_ == nullptr && !vertices_ && !kind->points)
      refuse("a " + frame.type, "Point or MultiPoint (--vertices takes the vertices of lines and polygons)");
    const std::size_t before = polygons_ == nullptr ? 0 : polygons_->polygons.size();
    if (!frame.geometry->finish(*kind, file_.points, polygons_))
      refuse("coordinates of another depth", std::to_string(kind->depth) + " brackets, as a " + frame.type + " has");
    if (polygons_ != nullptr) polygons_->end_geometry(before, no_feature);
  }

  /// At the end of a Feature; and at that of the outermost object, for geometries that are in none.
  void count_feature(const Frame& frame, bool is_outermost) {
    const auto first = polygons_->geometries.begin() + static_cast<std::ptrdiff_t>(frame.geometries);
    const auto has_none = [](const PolygonGeometry& geometry) { return geometry.feature == no_feature; };
    const bool is_geometry = is_outermost && frame.type != "FeatureCollection";
    if (frame.type != "Feature" && !is_geometry &&
        !(is_outermost && std::any_of(first, polygons_->geometries.end(), has_none)))
      return;
    for (auto geometry = first; geometry != polygons_->geometries.end(); ++geometry)
      if (has_none(*geometry)) geometry->feature = polygons_->features;
    for (const auto& [name, value] : frame.numbers) {
      const auto [at, is_new] = property_numbers_.emplace(name, polygons_->properties.size());
      if (is_new) polygons_->properties.push_back({name, {}});
      std::vector<double>& values = polygons_->properties[at->second].values;
      values.resize(polygons_->features + 1, std::numeric_limits<double>::quiet_NaN());
      values.back() = value;
    }
    ++polygons_->features;
  }

  void settle_crs() {
    if (!crs_name_ && !crs_is_unknown_) file_.crs = wgs84();
    if (!crs_name_) return;
    file_.crs = crs_of_name(*crs_name_);
    if (!file_.crs)
      file_.remarks.push_back("the system of coordinates is " + in_quotes(*crs_name_) +
                              ", which is not understood (--crs says it)");
  }

  static constexpr std::size_t no_feature = std::numeric_limits<std::size_t>::max();

  const char* begin_;
  const char* at_;  // how far the parser has read
  const char* end_;
  const std::string& name_;
  bool vertices_;
  PolygonFile* polygons_;
  PointFile file_ = {};
  std::vector<Frame> frames_ = {};
  Slot passed_over_ = Slot::ignored;  // what is of no interest but for its names and numbers
  std::size_t depth_ = 0;             // brackets that are open around it
  std::string inner_key_ = {};
  std::map<std::string, std::size_t> property_numbers_ = {};
  std::optional<std::string> crs_name_ = std::nullopt;
  bool crs_is_unknown_ = false;
  std::size_t without_geometry_ = 0;
  std::size_t events_ = 0;
};

/// What some editors put before the text.
std::string_view without_mark(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

}  // namespace

PointFile read_geojson_points(std::string_view text, const std::string& name, bool vertices) {
  return Events(without_mark(text), name, vertices).read();
}

PolygonFile read_geojson_polygons(std::string_view text, const std::string& name) {
  PolygonFile file;
  file.vertices = Events(without_mark(text), name, true, &file).read();
  for (NumberProperty& property : file.properties)
    property.values.resize(file.features, std::numeric_limits<double>::quiet_NaN());
  return file;
}

}  // namespace rbpa::app
