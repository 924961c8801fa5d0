#include "io/polygon/read_geojson.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
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
#include "io/number.h"
#include "io/polygon/feature_properties.h"
#include "io/polygon/geojson_geometry.h"
#include "io/polygon/json_id.h"
#include "io/scalar.h"
#include "io/text/lines.h"

namespace rbpa::app {

namespace {

/// The meaning of a value, by its key.
enum class Slot { ignored, type, coordinates, object, objects, crs, properties };

Slot slot_of(const std::string& key) {
  if (key == "type") return Slot::type;
  if (key == "coordinates") return Slot::coordinates;
  if (key == "geometry") return Slot::object;
  if (key == "features" || key == "geometries") return Slot::objects;
  if (key == "properties") return Slot::properties;
  return key == "crs" ? Slot::crs : Slot::ignored;
}

/// Turns the events of a JSON parser into points. The type of an object may follow its content.
class Events {
 public:
  /// Reads points; or, if `polygons` is not null, only polygons.
  Events(std::string_view text, const std::string& name, bool vertices, PolygonFile* polygons = nullptr,
         const std::optional<Condition>& where = std::nullopt, const std::optional<FieldChoice>& keeps = std::nullopt)
      : begin_(text.data()),
        at_(begin_),
        end_(begin_ + text.size()),
        name_(name),
        vertices_(vertices),
        polygons_(polygons),
        properties_(where, keeps,
                    [this](const std::string& found, const std::string& expected) { refuse(found, expected); }) {}

  PointFile read() {
    if (at_end()) refuse("nothing but blanks", "GeoJSON");
    while (!at_end()) {
      JsonPosition first(at_), last(end_);
      constexpr bool to_the_end = false;  // other texts may follow
      nlohmann::json::sax_parse(first, last, this, nlohmann::json::input_format_t::json, to_the_end);
    }
    if (without_geometry_ > 0) file_.warnings.push_back(counted(without_geometry_, "feature") + " without a geometry");
    settle_crs();
    properties_.finish(name_, file_);
    return std::move(file_);
  }

  bool null() {
    if (!frames_.empty() && is_in(Slot::object)) ++without_geometry_;
    if (is_in(Slot::crs)) crs_is_unknown_ = true;
    return scalar("null", is_in(Slot::object) || is_in(Slot::crs));
  }
  bool boolean(bool value) {
    take_property(value ? "true" : "false", value ? 1 : 0, true);
    return scalar(value ? "true" : "false", false);
  }
  bool number_integer(std::int64_t value) {
    // Read the text of 0 again: the parser loses the sign of −0.
    const bool negative_zero = value == 0 && at_ - begin_ >= 3 && at_[-3] == '-' && at_[-2] == '0';
    const bool at_the_end = value == 0 && at_ == end_ && at_ - begin_ >= 2 && at_[-2] == '-' && at_[-1] == '0';
    take_property(std::to_string(value), static_cast<double>(value), false);
    require_exact(value);
    return number(negative_zero || at_the_end ? -0.0 : static_cast<double>(value));
  }
  bool number_unsigned(std::uint64_t value) {
    take_property(std::to_string(value), static_cast<double>(value), false);
    require_exact(value);
    return number(static_cast<double>(value));
  }
  bool number_float(double value, const std::string& /*text*/) {
    take_property(text_of(value + 0.0), value, false);
    return number(value);
  }
  bool binary(const std::vector<std::uint8_t>& /*value*/) { return true; }

  bool string(const std::string& value) {
    if (inside(Slot::crs) && inner_key_ == "name") crs_name_ = value;
    take_property(value, not_a_number, true);
    if (is_in(Slot::type)) frames_.back().type = value;
    return scalar(in_quotes(value), is_in(Slot::type));
  }

  bool key(const std::string& key) {
    if (depth_ > 0) {
      inner_key_ = key;
      takes_property_ = is_property() && properties_.takes(key);
      return true;
    }
    Frame& frame = frames_.back();
    frame.slot = slot_of(key);
    frame.has_features = frame.has_features || key == "features";
    frame.is_feature = frame.is_feature || frame.slot == Slot::object || frame.slot == Slot::properties;
    if (frame.slot != Slot::coordinates) return true;
    if (frame.geometry) refuse("coordinates twice in an object", "once");
    frame.geometry = GeoJsonGeometry(file_.points.size());
    return true;
  }

  bool start_object(std::size_t /*size*/) {
    if (is_property()) properties_.require_scalar(inner_key_, "an object");
    if (passes_over(+1)) return true;
    if (!frames_.empty()) {
      const Frame& frame = frames_.back();
      if (frame.slot == Slot::crs || is_passed_over(frame.slot)) return pass_over(frame.slot);
      if (frame.slot == Slot::coordinates || frame.slot == Slot::type ||
          (frame.slot == Slot::objects && !frame.in_list))
        refuse("an object", "a " + expected(frame.slot));
      if (frame.geometry) refuse("an object in one with coordinates", "a geometry that has coordinates alone");
    }
    frames_.push_back({.begin = at_ - 1,
                       .geometries = polygons_ == nullptr ? 0 : polygons_->geometries.size(),
                       .points = file_.points.size()});
    return true;
  }
  bool end_object() {
    if (passes_over(-1)) return true;
    finish(frames_.back());
    if (polygons_ != nullptr) count_feature(frames_.back(), frames_.size() == 1);
    const bool is_feature = frames_.back().type == "Feature";
    if (is_feature)
      properties_.end_feature(frames_.back().properties, frames_.back().points, file_);
    else if (frames_.size() == 1)
      properties_.end_feature({}, file_.points.size(), file_);
    if (is_feature) ++features_;
    frames_.pop_back();
    return true;
  }

  bool start_array(std::size_t /*size*/) {
    if (is_property()) properties_.require_scalar(inner_key_, "a list");
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
  /// An object of GeoJSON whose end the parser has not reached.
  struct Frame {
    std::string type = {};
    Slot slot = Slot::ignored;
    bool in_list = false;         // within a list of objects
    const char* begin = nullptr;  // position of its opening bracket, or the next one
    bool has_features = false;    // it has a member "features"
    bool is_feature = false;      // its members show that it is a Feature
    std::optional<GeoJsonGeometry> geometry = std::nullopt;
    std::size_t geometries = 0;                                // number of geometries before it
    std::size_t points = 0;                                    // number of points before it
    std::vector<std::pair<std::string, double>> numbers = {};  // its properties that are numbers
    std::vector<Property> properties = {};                     // its properties that are read
  };

  /// Returns whether the parser is at the value of a property of a Feature.
  bool is_property() const { return depth_ == 1 && passed_over_ == Slot::properties; }

  void take_property(const std::string& text, double value, bool is_text) {
    if (takes_property_ && is_property()) frames_.back().properties.push_back({inner_key_, text, value, is_text});
  }

  static bool is_passed_over(Slot slot) { return slot == Slot::ignored || slot == Slot::properties; }

  static std::string expected(Slot slot) {
    if (slot == Slot::type) return "type: a text";
    if (slot == Slot::coordinates) return "list of coordinates";
    return slot == Slot::object || slot == Slot::crs ? "GeoJSON object" : "list of GeoJSON objects";
  }

  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    const std::size_t before = count_line_ends({begin_, static_cast<std::size_t>(at_ - begin_)});
    const bool behind_end = at_ != begin_ && at_[-1] == '\n';  // the parser has read the line end already
    bad_input(at_line(name_, before + (behind_end ? 0 : 1)) + feature_text(), found, expected);
  }
  /// Returns ": feature 700 (id 700)", as the whole file may be one line; empty outside of features.
  std::string feature_text() const {
    const bool in_collection = frames_.size() > 1 && frames_.front().has_features;
    if (!in_collection && (frames_.empty() || !frames_.front().is_feature)) return "";
    const std::string id = id_text(frames_[in_collection ? 1 : 0].begin);
    const bool is_only = !in_collection && features_ == 0 && id.empty();
    return is_only ? "" : ": feature " + std::to_string(features_) + id;
  }
  /// Returns the id of the object that begins at `begin`, as text for messages.
  std::string id_text(const char* begin) const {
    const std::string id = json_id(std::find(begin, end_, '{'), end_);
    return id.empty() ? "" : " (id " + shown(id) + ")";
  }
  bool check(const char* fault) const {
    if (fault != nullptr) refuse(fault, "positions of two numbers or more, such as [1, 2], and lists of them");
    return true;
  }

  bool at_end() {
    constexpr char record_separator = '\x1E';  // before each text, by RFC 8142
    while (at_ != end_ && (is_blank(*at_) || *at_ == '\n' || *at_ == record_separator)) ++at_;
    return at_ == end_;
  }

  bool is_in(Slot slot) const { return depth_ == 0 && !frames_.empty() && frames_.back().slot == slot; }
  bool inside(Slot slot) const { return depth_ > 0 && passed_over_ == slot; }

  /// Begins to ignore the content up to the closing bracket, except names and numbers that `slot` needs.
  bool pass_over(Slot slot) {
    passed_over_ = slot;
    depth_ = 1;
    return true;
  }

  /// Returns whether the object or array that begins (`step` > 0) or ends is within ignored content. Throws Cancelled.
  bool passes_over(int step) {
    if (++events_ % 65536 == 0) stop_if_interrupted();
    if (depth_ == 0) return false;
    depth_ = step > 0 ? depth_ + 1 : depth_ - 1;
    return true;
  }

  /// Takes a value that is not a coordinate, object or array. Throws BadInput unless the value `fits` its key or is
  /// ignored.
  bool scalar(const std::string& found, bool fits) const {
    if (depth_ > 0) return true;
    if (frames_.empty()) refuse(found, "a GeoJSON object");
    if (!fits && !is_passed_over(frames_.back().slot)) refuse(found, "a " + expected(frames_.back().slot));
    return true;
  }

  /// Throws BadInput for an integer among coordinates that doubles do not represent: its bits span more than 53 places.
  template <typename Integer>
  void require_exact(Integer value) const {
    const auto size = value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    if (is_in(Slot::coordinates) && size != 0 && (size >> std::countr_zero(size)) >> 53U != 0)
      refuse(std::to_string(value), expected_instead(NumberFault::rounded_integer));
  }

  bool number(double value) {
    if (inside(Slot::crs) && inner_key_ == "code" && value > 0 && value < 1e9 && value == std::trunc(value))
      crs_name_ = "EPSG:" + std::to_string(static_cast<std::uint64_t>(value));
    if (inside(Slot::properties) && depth_ == 1 && polygons_ != nullptr)
      frames_.back().numbers.emplace_back(inner_key_, value);
    if (is_in(Slot::coordinates)) return check(frames_.back().geometry->add(value));
    return scalar("a number", false);
  }

  /// Finishes an object at its end, where its type is known.
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
    if (!frame.geometry) refuse("a " + frame.type + " without coordinates", "coordinates");
    if (polygons_ != nullptr && !kind->rings) refuse("a " + frame.type, "Polygon or MultiPolygon");
    if (polygons_ == nullptr && !vertices_ && !kind->points)
      refuse("a " + frame.type, "Point or MultiPoint (--vertices takes the vertices of lines and polygons)");
    const std::size_t before = polygons_ == nullptr ? 0 : polygons_->polygons.size();
    if (!frame.geometry->finish(*kind, file_, polygons_))
      refuse("coordinates nested " + std::to_string(frame.geometry->depth()) + " lists deep",
             std::to_string(kind->depth) + ", as those of a " + frame.type);
    if (polygons_ != nullptr) polygons_->end_geometry(before, no_feature);
  }

  /// Counts a feature: at the end of a Feature, and of the outermost object for geometries that are in no Feature.
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
    if (!crs_name_ && !crs_is_unknown_) (file_.crs = wgs84())->implied = true;
    if (!crs_name_) return;
    file_.crs = crs_of_name(*crs_name_);
    if (!file_.crs) file_.warnings.push_back(warning_on_crs(*crs_name_));
  }

  static constexpr std::size_t no_feature = std::numeric_limits<std::size_t>::max();
  static constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

  const char* begin_;
  const char* at_;  // position of the parser
  const char* end_;
  const std::string& name_;
  bool vertices_;
  PolygonFile* polygons_;
  FeatureProperties properties_;
  bool takes_property_ = false;  // the value of the current property is read
  PointFile file_ = {};
  std::vector<Frame> frames_ = {};
  Slot passed_over_ = Slot::ignored;  // the content that is ignored, except its names and numbers
  std::size_t depth_ = 0;             // number of open brackets in that content; 0: nothing is ignored
  std::string inner_key_ = {};
  std::map<std::string, std::size_t> property_numbers_ = {};
  std::optional<std::string> crs_name_ = std::nullopt;
  bool crs_is_unknown_ = false;
  std::size_t without_geometry_ = 0;
  std::size_t features_ = 0;  // number of features that have ended
  std::size_t events_ = 0;
};

}  // namespace

PointFile read_geojson_points(std::string_view text, const std::string& name, bool vertices,
                              const std::optional<Condition>& where, const std::optional<FieldChoice>& keeps) {
  return Events(text, name, vertices, nullptr, where, keeps).read();
}

PolygonFile read_geojson_polygons(std::string_view text, const std::string& name) {
  PolygonFile file;
  file.vertices = Events(text, name, true, &file).read();
  for (NumberProperty& property : file.properties)
    property.values.resize(file.features, std::numeric_limits<double>::quiet_NaN());
  return file;
}

}  // namespace rbpa::app
