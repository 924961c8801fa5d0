#include "io/polygon/wkt.h"

#include <algorithm>
#include <cctype>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/text/lines.h"

namespace rbpa::app {
namespace {

/// A kind of geometry: its name, the number of brackets around its positions (0 for a collection), and whether the
/// innermost brackets are rings.
struct Kind {
  std::string_view name;
  int depth;
  bool rings = false;
};
constexpr Kind kinds[] = {{"GEOMETRYCOLLECTION", 0}, {"POINT", 1},
                          {"MULTIPOINT", 1},         {"LINESTRING", 1},
                          {"MULTILINESTRING", 2},    {"TRIANGLE", 2, true},
                          {"POLYGON", 2, true},      {"MULTIPOLYGON", 3, true},
                          {"TIN", 3, true},          {"POLYHEDRALSURFACE", 3, true}};

/// The greatest depth of collections in collections.
constexpr int deepest = 32;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// Returns the kind called `name`; null if there is none.
const Kind* find_kind(std::string_view name) {
  const auto* kind = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return k.name == name; });
  return kind == std::end(kinds) ? nullptr : kind;
}

bool is_dimension(std::string_view word) { return word == "Z" || word == "M" || word == "ZM"; }

}  // namespace

void WktGeometries::skip_space() {
  while (!text_.empty() && is_space(text_.front())) text_.remove_prefix(1);
}

std::string_view WktGeometries::take_word() {
  skip_space();
  std::size_t size = 0;
  while (size < text_.size() && std::isalpha(static_cast<unsigned char>(text_[size])) != 0) ++size;
  const std::string_view word = text_.substr(0, size);
  text_.remove_prefix(size);
  return word;
}

bool WktGeometries::take_sign(char sign) {
  skip_space();
  if (text_.empty() || text_.front() != sign) return false;
  text_.remove_prefix(1);
  return true;
}

void WktGeometries::expect_sign(char sign) {
  if (!take_sign(sign)) refuse(in_quotes({&sign, 1}));
}

void WktGeometries::refuse(const std::string& expected) const {
  const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
  throw WktFault{text_.data(), text_.empty() ? "the end of the text" : in_quotes(text_.substr(0, end)), expected};
}

void WktGeometries::take_srid() {
  const std::string_view before = text_;
  if (in_capitals(take_word()) != "SRID" || !take_sign('=')) {
    text_ = before;
    return;
  }
  skip_space();
  const std::size_t digits = std::min(text_.find_first_not_of("0123456789"), text_.size());
  if (digits == 0 || digits > 9) refuse("the number of a coordinate reference system");
  const std::string code(text_.substr(0, digits));
  text_.remove_prefix(digits);
  expect_sign(';');
  if (code.find_first_not_of('0') == std::string::npos) return;  // SRID 0 means unknown
  const std::optional<Crs> crs = crs_of_name("EPSG:" + code);
  if (!crs) {
    crs_warning_ = warning_on_crs("EPSG:" + code);
    return;
  }
  if (crs_ && crs_->code != crs->code)
    throw WktFault{before.data(), "SRID=" + code, "one system for all points, SRID=" + crs_->code};
  crs_ = crs;
}

bool WktGeometries::next(std::vector<Point>& points) {
  do skip_space();
  while (take_sign(';'));  // some writers end each geometry with a semicolon
  if (text_.empty()) return false;
  take_srid();
  take_geometry(points, 0);
  if (polygons_ != nullptr) ++polygons_->features;
  return true;
}

void WktGeometries::take_geometry(std::vector<Point>& points, int depth) {
  skip_space();
  const std::string_view begin = text_;
  std::string name = in_capitals(take_word());
  measured_ = false;
  // Accept "POINT Z (", "POINTZ(" and "POINT(", which are all in use.
  for (const std::string_view dimension : {"ZM", "Z", "M"})
    if (find_kind(name) == nullptr && name.ends_with(dimension)) {
      name.resize(name.size() - dimension.size());
      measured_ = dimension == "M";
    }
  const Kind* kind = find_kind(name);
  if (kind == nullptr) {
    text_ = begin;
    refuse("a geometry, such as 'POINT (1 2)'");
  }
  const std::string_view behind_name = text_;
  std::string word = in_capitals(take_word());
  if (is_dimension(word)) {
    measured_ = word == "M";
    word = in_capitals(take_word());
  }
  if (word == "EMPTY") return;
  if (!word.empty()) {
    text_ = behind_name;
    refuse("'(' or EMPTY");
  }
  if (name == "GEOMETRYCOLLECTION") {
    if (depth == deepest) refuse("at most " + std::to_string(deepest) + " nested collections");
    expect_sign('(');
    do take_geometry(points, depth + 1);
    while (take_sign(','));
    return expect_sign(')');
  }
  if (polygons_ != nullptr && !kind->rings) throw WktFault{begin.data(), name, "POLYGON or MULTIPOLYGON"};
  if (name == "POINT") {
    expect_sign('(');
    take_position(points);
    return expect_sign(')');
  }
  if (name == "MULTIPOINT") return take_list(points);
  if (!vertices_)
    throw WktFault{begin.data(), name, "POINT or MULTIPOINT (--vertices takes the vertices of lines and polygons)"};
  const std::size_t before = polygons_ == nullptr ? 0 : polygons_->polygons.size();
  take_lists(points, kind->depth, kind->rings);
  if (polygons_ != nullptr) polygons_->end_geometry(before, polygons_->features);
}

/// Reads nested brackets, `brackets` deep. The innermost are lines, or, if `rings`, rings, whose last point repeats the
/// first.
void WktGeometries::take_lists(std::vector<Point>& points, int brackets, bool rings) {
  if (brackets == 1) {
    const std::size_t first = points.size();
    if (rings)
      take_ring(points);
    else
      take_list(points);
    return lines_.push_back({first, points.size(), rings});
  }
  if (take_empty()) return;
  if (brackets == 2 && polygons_ != nullptr) polygons_->polygons.emplace_back();
  expect_sign('(');
  do take_lists(points, brackets - 1, rings);
  while (take_sign(','));
  expect_sign(')');
}

void WktGeometries::take_ring(std::vector<Point>& points) {
  const std::size_t first = points.size();
  take_list(points);
  if (points.size() > first + 1 && points.back() == points[first]) {
    points.pop_back();
    z_.pop_back();
  }
  if (polygons_ == nullptr) return;
  polygons_->add_ring(first, points.size(), polygons_->polygons.back().shell.points.empty());
}

bool WktGeometries::take_empty() {
  skip_space();
  if (in_capitals(text_.substr(0, 5)) != "EMPTY") return false;
  text_.remove_prefix(5);
  return true;
}

/// Reads "(1 2, 3 4)" or "((1 2), (3 4))" or "EMPTY". For MULTIPOINT the standard has the second form; many writers use
/// the first.
void WktGeometries::take_list(std::vector<Point>& points) {
  if (take_empty()) return;
  expect_sign('(');
  do {
    if (take_empty()) continue;
    if (take_sign('(')) {
      take_position(points);
      expect_sign(')');
    } else {
      take_position(points);
    }
  } while (take_sign(','));
  expect_sign(')');
}

/// Reads a position of two to four numbers.
void WktGeometries::take_position(std::vector<Point>& points) {
  double coordinate[2] = {0, 0}, z = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 4; ++i) {
    skip_space();
    if (i >= 2 && (text_.empty() || text_.front() == ',' || text_.front() == ')')) break;
    const auto ends_at = [this](const char* end) {
      return end == text_.data() + text_.size() || is_space(*end) || *end == ',' || *end == ')';
    };
    ParsedNumber number = parse_number(text_.data(), text_.data() + text_.size());
    if (number.fault != NumberFault::none || !ends_at(number.end)) {
      // Show only the word in the message, not the rest of the text.
      const std::size_t size = std::min(text_.find_first_of(" \t\r\n,()"), text_.size());
      const ParsedNumber word = parse_written_number(text_.substr(0, size));
      if (word.fault == NumberFault::none)
        number = word;
      else if (number.fault != NumberFault::none && size > 0)
        throw WktFault{text_.data(), in_quotes(text_.substr(0, size)), expected_instead(number.fault)};
      else if (number.fault != NumberFault::none)
        refuse("a number");
    }
    if (i < 2) coordinate[i] = number.value;
    if (i == 2 && !measured_) heights_.take(z = number.value);
    text_.remove_prefix(static_cast<std::size_t>(number.end - text_.data()));
    if (!ends_at(text_.data())) refuse("a blank, ',' or ')' after a number");
  }
  points.push_back({coordinate[0], coordinate[1]});
  z_.push_back(z);
}

namespace {

PointFile read_all(WktGeometries& geometries, std::string_view text, const std::string& name) {
  PointFile file;
  try {
    for (std::size_t i = 0; geometries.next(file.points); ++i)
      if (i % 16384 == 0) stop_if_interrupted();
  } catch (const WktFault& fault) {
    const std::size_t before = count_line_ends(text.substr(0, static_cast<std::size_t>(fault.at - text.data())));
    bad_input(at_line(name, before + 1), fault.found, fault.expected);
  }
  file.crs = geometries.crs();
  if (!geometries.crs_warning().empty()) file.warnings.push_back(geometries.crs_warning());
  file.heights = geometries.heights();
  file.z = geometries.z();
  file.lines = geometries.lines();
  return file;
}

}  // namespace

PointFile read_wkt_points(std::string_view text, const std::string& name, bool vertices) {
  WktGeometries geometries(text, vertices);
  return read_all(geometries, text, name);
}

PolygonFile read_wkt_polygons(std::string_view text, const std::string& name) {
  PolygonFile file;
  WktGeometries geometries(text, file);
  file.vertices = read_all(geometries, text, name);
  return file;
}

}  // namespace rbpa::app
