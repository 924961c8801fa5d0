#include "io/table/text_points.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/formats.h"
#include "io/gis/wkt_geometry.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/table/decimal_comma.h"
#include "io/table/field_text.h"
#include "io/table/fields.h"
#include "io/table/header.h"
#include "io/table/line_selection.h"
#include "io/table/separator.h"

namespace rbpa::app {
class TextTable::Reader {
 public:
  Reader(std::string name, TableRule rule)
      : lines_({}),
        name_(std::move(name)),
        rule_(std::move(rule)),
        selection_(std::move(rule_.where), rule_.skip_invalid) {}

  void read(std::string_view text) {
    if (lines_.number() == 0 && !has_text_) text = beyond_byte_order_mark(text, name_);
    has_text_ = has_text_ || !text.empty();
    lines_ = Lines(text, lines_.number());
    forget_points();
    if (!lines_.next_with_content()) return;
    if (place_ != Place::data && !find_data()) return;

    // A point takes four characters or more; room that is not used costs nothing.
    file_.points.reserve(std::min(count_line_ends(lines_.rest()) + 1, text.size() / 4 + 1));
    do {
      take_line();
      if (width_ && !wkt_ && !comma_.is_used() && !selection_.has_condition()) read_plain_lines();
    } while (lines_.next_with_content());
  }

  void finish() {
    const bool by_name = rule_.columns && (rule_.columns->x.number == 0 || rule_.columns->y.number == 0);
    if (by_name && (place_ == Place::hint || place_ == Place::header))
      bad_input(name_, "no header line", "one with the column names");
    selection_.tell(any_points_ || !file_.points.empty(), name_, file_.remarks);
  }

  PointFile& file() { return file_; }

 private:
  /// What the next line may be.
  enum class Place { hint, header, first_data, data };

  /// Goes on from a line with content to the first line of data, or returns false when that is not in this text.
  bool find_data() {
    if (place_ == Place::hint) {
      place_ = Place::header;
      if (is_separator_hint(lines_.line()) && !lines_.next_with_content()) return false;
    }
    if (place_ == Place::header) {
      const bool header = take_header();
      selection_.find_columns(header ? split(header_, separator_of(header_)) : std::vector<std::string_view>(), lines_,
                              name_);
      place_ = Place::first_data;
      if (!header) first_line_ = lines_.number();
      if (header && !lines_.next_with_content()) return false;
    }
    separator_ = data_separator();
    first_point_ = lines_.number();
    place_ = Place::data;
    return true;
  }

  /// Points of the text before are elsewhere now; what is to be known of them is not.
  void forget_points() {
    const auto is_whole = [](const Point& p) { return std::trunc(p.x) == p.x && std::trunc(p.y) == p.y; };
    all_whole_ = all_whole_ && std::all_of(file_.points.begin(), file_.points.end(), is_whole);
    any_points_ = any_points_ || !file_.points.empty();
    file_.points.clear();
  }

  std::string here() const { return at_line(name_, lines_.number()); }

  /// Finds the columns; whether the current line is the header.
  bool take_header() {
    const std::vector<std::string_view> fields = split(lines_.line(), separator_of(lines_.line()));
    if (rule_.columns) {
      const auto position = [&](const Column& column) {
        return column.number > 0 ? column.number - 1 : find_column(fields, column.name, lines_, name_);
      };
      x_ = position(rule_.columns->x);
      y_ = position(rule_.columns->y);
    } else if (find_by_header(fields)) {
      return accept_header(fields);
    }
    const bool by_name = rule_.columns && (rule_.columns->x.number == 0 || rule_.columns->y.number == 0);
    const std::size_t needed = std::max(x_, y_) + 1;
    if (fields.size() < needed) {
      const bool text_only = std::none_of(fields.begin(), fields.end(), is_number);
      bad_input(here(), text_only ? in_quotes(lines_.line()) : counted(fields.size(), "column"),
                needed == 2 ? (text_only ? "two numbers" : "two columns")
                            : "at least " + counted(needed, "column") + ", as --columns asks");
    }
    if (x_ == y_) refuse_one_column(fields[x_]);  // under two names, or by name and by number
    if (!by_name && (is_number(fields[x_]) || is_number(fields[y_]))) {
      // Only the ending .xyz makes a third number a height; elsewhere it may be anything.
      if (!rule_.columns && fields.size() > 2 && input_ending(name_) == "xyz") z_ = 2;
      return false;
    }
    if (!by_name && is_missing(fields[x_]) && is_missing(fields[y_])) return false;
    file_.degrees = is_longitude(fields[x_]) && is_latitude(fields[y_]);
    if (is_latitude(fields[x_]) && is_longitude(fields[y_]))
      file_.remarks.push_back("x is the latitude " + in_quotes(fields[x_]) + " and y the longitude " +
                              in_quotes(fields[y_]) + ", as --columns asks");
    return accept_header(fields);
  }

  bool accept_header(const std::vector<std::string_view>& fields) {
    first_line_ = lines_.number();
    header_ = lines_.line();
    width_ = fields.size();
    if (!wkt_) z_ = find_height(fields);
    if (z_ == x_ || z_ == y_) z_.reset();
    return true;
  }

  /// Whether the line is a header with names that say where the points are.
  bool find_by_header(const std::vector<std::string_view>& fields) {
    const std::optional<std::size_t> geometries = find_wkt(fields);
    const std::optional<NamedColumns> found = find_coordinates(fields);
    if (found && geometries && next_line_has_geometry()) {
      file_.remarks.push_back("the geometries of column " + in_quotes(fields[*geometries]) + " are read, and not " +
                              in_quotes(fields[found->x]) + " and " + in_quotes(fields[found->y]) +
                              " (--columns chooses these)");
      wkt_ = geometries;
      return true;
    }
    if (found) {
      x_ = found->x;
      y_ = found->y;
      file_.degrees = found->degrees;
      if (x_ != 0 || y_ != 1)
        file_.remarks.push_back("x is column " + std::to_string(x_ + 1) + ", " + in_quotes(fields[x_]) +
                                ", and y is column " + std::to_string(y_ + 1) + ", " + in_quotes(fields[y_]) +
                                ", as the header says (--columns chooses others)");
      return true;
    }
    wkt_ = geometries;
    return wkt_.has_value();
  }

  /// A column that is called so may have something else in it, such as the bytes of a geometry, or nothing.
  bool next_line_has_geometry() const {
    const std::string_view rest = lines_.rest();
    const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size()));
    constexpr std::string_view kinds[] = {"POINT", "LINESTRING", "POLYGON", "GEOMETRYCOLLECTION"};
    const auto same = [](char a, char b) { return std::toupper(static_cast<unsigned char>(a)) == b; };
    return line.find('(') != std::string_view::npos &&
           std::any_of(std::begin(kinds), std::end(kinds), [&](std::string_view kind) {
             return std::search(line.begin(), line.end(), kind.begin(), kind.end(), same) != line.end();
           });
  }

  /// That of the line, which is the first of data. The commas of a geometry separate none of its fields.
  char data_separator() const {
    if (!wkt_) return separator_of(lines_.line());
    return header_.find_first_of(",;\t") == std::string_view::npos ? ';' : separator_of(header_);
  }

  /// Reads the lines that hold nothing but fields without quotes, as nearly all do: without looking for their ends first.
  void read_plain_lines() {
    for (Point p; const char* behind = read_plain_line(p); lines_.pass_line(behind)) {
      if (file_.points.size() % 16384 == 0) stop_if_interrupted();
      file_.points.push_back(p);
    }
  }

  /// Where the next line ends, when it is plain and a point; else null.
  const char* read_plain_line(Point& p) {
    const char* at = lines_.rest().data();
    const char* const end = at + lines_.rest().size();
    const auto skip_blanks = [&](char but) {
      while (at != end && is_blank(*at) && *at != but) ++at;
    };
    const char kept = separator_ == blanks ? '\0' : separator_;  // a tab may be the separator
    skip_blanks('\0');
    for (std::size_t column = 0; column < *width_; ++column) {
      if (column > 0) {
        const char* const field_end = at;
        skip_blanks(kept);
        if (separator_ == blanks) {
          if (at == field_end) return nullptr;
        } else {
          if (at == end || *at != separator_) return nullptr;
          ++at;
          skip_blanks(kept);
        }
      }
      if (column == x_ || column == y_) {
        const ParsedNumber number = parse_number(at, end);
        if (number.fault != NumberFault::none) return nullptr;
        if (column == x_) p.x = number.value;
        if (column == y_) p.y = number.value;
        at = number.end;
      } else {
        const char* const field = at;
        while (at != end && !is_blank(*at) && *at != separator_ && *at != '\n' && *at != '"' && *at != '#') ++at;
        if (at == field) return nullptr;
        if (column == z_) take_height({field, static_cast<std::size_t>(at - field)});
      }
    }
    skip_blanks('\0');
    return at == end || *at == '\n' ? at : nullptr;
  }

  /// The points of the current line, if it counts.
  void take_line() {
    selection_.attempt([this] {
      const auto read = [this](Fields& fields) { return read_number(fields, of_where); };
      const auto take = [this](std::size_t count) { take_width(count); };
      if (selection_.is_selected(Fields(lines_.line(), separator_), read, take))
        wkt_ ? read_geometries() : read_point();
    });
  }

  void read_point() {
    Fields fields(lines_.line(), separator_);
    std::optional<double> x, y;
    std::size_t count = 0;
    for (; !fields.at_end(); ++count) {
      if (count == x_ || count == y_) {
        const double value = read_number(fields);
        if (count == x_) x = value;
        if (count == y_) y = value;
      } else {
        const std::string_view field = fields.take();
        if (count == z_) take_height(without_quotes(field));
      }
    }
    take_width(count);
    file_.points.push_back({*x, *y});
  }

  /// A field that is no number is no height. That two differ is enough.
  void take_height(std::string_view field) {
    const ParsedNumber number = parse_whole_number(field);
    if (number.fault == NumberFault::none) file_.heights.take(number.value);
    if (file_.heights.differ()) z_.reset();
  }

  void take_width(std::size_t count) {
    if (!width_) width_ = count;
    if (count != *width_)
      bad_input(here(), counted(count, "column") + " (" + in_quotes(lines_.line()) + ")",
                std::to_string(*width_) + " as in line " + std::to_string(first_line_));
  }

  /// The geometries of the current line, in its field of well-known text.
  void read_geometries() {
    Fields fields(lines_.line(), separator_);
    std::string_view text;
    std::size_t count = 0;
    for (; !fields.at_end(); ++count) {
      const std::string_view field = without_quotes(fields.take());
      if (count == *wkt_) text = field;
    }
    take_width(count);
    const std::size_t first = file_.points.size();
    WktGeometries geometries(text, rule_.vertices);
    try {
      while (geometries.next(file_.points)) continue;
    } catch (const WktFault& fault) {
      file_.points.resize(first);
      bad_input(here(), fault.found, fault.expected);
    }
    if (file_.points.size() == first)
      bad_input(here(), in_quotes(text), "a geometry, such as 'POINT (1 2)'" + selection_.hint());
    file_.heights.take(geometries.heights());
    if (!geometries.crs()) return;
    if (file_.crs && file_.crs->code != geometries.crs()->code)
      bad_input(here(), geometries.crs()->text(), file_.crs->text() + " as in lines before");
    file_.crs = geometries.crs();
  }

  /// `where`, for messages, is empty for a coordinate.
  double read_number(Fields& fields, std::string_view where = {}) {
    const ParsedNumber number = parse_number(fields.begin_of_field(), fields.end_of_line());
    const bool whole_field = number.fault == NumberFault::none && !comma_.is_used() && fields.take_up_to(number.end);
    if (whole_field) return number.value;
    const std::string_view field = without_quotes(fields.take());
    if (separator_ != ',' && field.find(',') != std::string_view::npos) return read_decimal_comma(field);
    comma_.refuse_point(field, here());
    const ParsedNumber whole = parse_whole_number(field);
    if (whole.fault != NumberFault::none)
      bad_input(here(), in_quotes(field),
                expected_instead(whole.fault) + std::string(where) +
                    (is_missing(field) || !where.empty() ? selection_.hint() : hint(whole.fault)));
    return whole.value;
  }

  /// A sign is either: numbers with a point before this one leave it no number.
  double read_decimal_comma(std::string_view field) {
    const double value = comma_.read(field, here());
    if (!comma_.is_used()) {
      const auto is_whole = [](const Point& p) { return std::trunc(p.x) == p.x && std::trunc(p.y) == p.y; };
      const bool all_whole = all_whole_ && std::all_of(file_.points.begin(), file_.points.end(), is_whole);
      comma_.begin(field, lines_.number(), all_whole, here(), file_.remarks);
    }
    return value;
  }

  /// The first point has text where a number should be: others of its columns may be meant.
  std::string hint(NumberFault fault) const {
    if (fault != NumberFault::not_a_number || lines_.number() != first_point_) return "";
    if (split(lines_.line(), separator_).size() <= 2) return "";
    return " (--columns X,Y chooses other columns" + (header_.empty() ? "" : " of " + in_quotes(header_)) + ")";
  }

  Lines lines_;
  std::string name_;
  TableRule rule_;
  PointFile file_ = {};
  Place place_ = Place::hint;
  bool has_text_ = false;
  bool any_points_ = false, all_whole_ = true;  // of texts before
  char separator_ = blanks;
  std::size_t x_ = 0;
  std::size_t y_ = 1;
  std::optional<std::size_t> wkt_ = std::nullopt;    // the column of geometries, in place of both
  std::optional<std::size_t> z_ = std::nullopt;      // that of heights, until it is known that they differ
  std::size_t first_line_ = 0;                       // the line that says how many columns there are
  std::optional<std::size_t> width_ = std::nullopt;  // how many
  std::string header_ = {};                          // empty without one
  std::size_t first_point_ = 0;                      // its line
  DecimalComma comma_ = {};
  LineSelection selection_;
};

TextTable::TextTable(const std::string& name, const TableRule& rule) : reader_(std::make_unique<Reader>(name, rule)) {}
TextTable::~TextTable() = default;

void TextTable::read(std::string_view text) { reader_->read(text); }
void TextTable::finish() { reader_->finish(); }
PointFile& TextTable::file() { return reader_->file(); }

PointFile read_text_points(std::string_view text, const std::string& name, const TableRule& rule) {
  TextTable table(name, rule);
  table.read(text);
  table.finish();
  return std::move(table.file());
}

}  // namespace rbpa::app
