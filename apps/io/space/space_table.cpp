#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "io/points/longitude.h"
#include "io/space/readers.h"
#include "io/space/text_colors.h"
#include "io/table/decimal_comma.h"
#include "io/table/field_text.h"
#include "io/table/fields.h"
#include "io/table/header.h"
#include "io/table/line_selection.h"
#include "io/table/separator.h"

namespace rbpa::app {
namespace {

/// What the last three of six columns are that nothing names.
enum class Unnamed { by_content, normals };

class SpaceTable {
 public:
  SpaceTable(std::string_view text, const std::string& name, const SpaceChoice& choice, Unnamed unnamed)
      : lines_(beyond_byte_order_mark(text, name)),
        name_(name),
        columns_(choice.columns),
        selection_(choice.where, choice.skip_invalid),
        by_content_(unnamed == Unnamed::by_content) {}

  /// Nothing where three unnamed columns are normals, not all of which have a direction: they are to be read as such.
  std::optional<SpacePoints> read() {
    bool line = lines_.next_with_content();
    if (line && is_separator_hint(lines_.line())) line = lines_.next_with_content();
    const bool header = line && take_first_line();
    if (!line && is_by_name()) bad_input(name_, "no header line", "one with the column names");
    if (line) find_fields(header);
    if (header) line = lines_.next_with_content();
    if (!line) return std::move(file_);

    separator_ = separator_of(lines_.line());
    reserve();
    do selection_.attempt([this] { take_line(); });
    while (lines_.next_with_content());
    if (unnamed_ && !settle_unnamed()) return std::nullopt;
    if (has_colors_) colors_.settle(false, file_);
    if (degrees_ && !file_.points.empty()) file_.remarks.push_back(remark_on_degrees(file_.points));
    selection_.tell(!file_.points.empty(), name_, file_.remarks);
    return std::move(file_);
  }

 private:
  std::string here() const { return at_line(name_, lines_.number()); }
  std::string found_columns(std::size_t count) const {
    return counted(count, "column") + " (" + in_quotes(lines_.line()) + ")";
  }
  bool is_by_name() const {
    return columns_ && std::any_of(columns_->begin(), columns_->end(), [](const Column& c) { return c.number == 0; });
  }

  /// Finds the columns; whether the current line is the header.
  bool take_first_line() {
    const std::vector<std::string_view> fields = split(lines_.line(), separator_of(lines_.line()));
    first_line_ = lines_.number();
    if (columns_) {
      take_choice(fields);
    } else if (is_header(fields, {0, 1, 2})) {
      find_by_header(fields);
    } else {
      if (fields.size() != 3 && fields.size() != 6) refuse_width(fields);
      for (std::size_t i = 0; i < fields.size(); ++i) place_.push_back(i);
      unnamed_ = fields.size() == 6;
    }
    has_normals_ = place_.size() == 6;
    const bool header = is_by_name() || is_header(fields, place_);
    if (header) width_ = fields.size();
    if (header) find_colors(fields);
    if (header) degrees_ = is_longitude(fields[place_[0]]) && is_latitude(fields[place_[1]]);
    for (std::size_t i = 0; i < place_.size(); ++i) {
      if (place_[i] == none) continue;
      if (place_[i] >= role_.size()) role_.resize(place_[i] + 1, none);
      role_[place_[i]] = i;
    }
    return header;
  }

  /// Behind the others in place_, unless they are meant to be something else.
  void find_colors(const std::vector<std::string_view>& header) {
    const std::vector<std::size_t> colors = find_color_columns(header);
    const bool taken = std::any_of(colors.begin(), colors.end(), [this](std::size_t color) {
      return std::find(place_.begin(), place_.end(), color) != place_.end();
    });
    if (colors.empty() || taken) return;
    has_colors_ = true;
    place_.resize(first_color, none);
    place_.insert(place_.end(), colors.begin(), colors.end());
  }

  /// Whole numbers up to 255, or to 65535, are colours where one is greater than 1.
  bool settle_unnamed() {
    const bool colors = all_channels_ && greatest_ > 1;
    if (by_content_ && !colors && no_direction_) return false;
    if (by_content_ && colors) {
      const double unit = greatest_ > 255 ? 256 : 1;
      const auto byte = [unit](double channel) { return static_cast<std::uint8_t>(channel / unit); };
      for (const Point3& color : file_.normals) file_.colors.push_back({byte(color.x), byte(color.y), byte(color.z)});
      file_.normals.clear();
    }
    if (file_.points.empty()) return true;
    file_.remarks.push_back(
        by_content_ && colors
            ? "columns 4 to 6 are read as colours, as they are whole numbers (--columns 1,2,3,4,5,6 reads normals)"
            : "columns 4 to 6 are read as normals (a header 'x y z r g b' makes them colours)");
    return true;
  }

  /// Those of --where, by the current line if it is the header.
  void find_fields(bool header) {
    if (!selection_.has_condition()) return;
    const char separator = separator_of(lines_.line());
    selection_.find_columns(header ? split(lines_.line(), separator) : std::vector<std::string_view>(), lines_, name_);
  }

  [[noreturn]] void refuse_width(const std::vector<std::string_view>& fields) const {
    const bool text_only = std::none_of(fields.begin(), fields.end(), is_number);
    if (text_only) bad_input(here(), in_quotes(lines_.line()), "3 or 6 numbers");
    bad_input(here(), found_columns(fields.size()),
              fields.size() > 3 ? "3 or 6 (--columns X,Y,Z chooses some of more)" : "3 or 6");
  }

  /// Where one of them is a number, or says that there is none, the line is data.
  static bool is_header(const std::vector<std::string_view>& fields, const std::vector<std::size_t>& places) {
    std::size_t missing = 0;
    for (const std::size_t i : places) {
      if (i >= fields.size() || is_number(fields[i])) return false;
      if (is_missing(fields[i])) ++missing;
    }
    return missing < places.size();
  }

  void take_choice(const std::vector<std::string_view>& fields) {
    for (const Column& column : *columns_)
      place_.push_back(column.number > 0 ? column.number - 1 : find_column(fields, column.name, lines_, name_));
    const std::size_t needed = *std::max_element(place_.begin(), place_.end()) + 1;
    if (fields.size() < needed)
      bad_input(here(), found_columns(fields.size()), "at least " + counted(needed, "column") + ", as --columns asks");
    for (std::size_t i = 0; i < place_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (place_[i] == place_[k])
          refuse_repeated_column(fields[place_[i]]);  // under two names, or by name and by number
  }

  /// Of names that are not known only the number of columns says what they are.
  void find_by_header(const std::vector<std::string_view>& fields) {
    place_ = find_space_columns(fields);
    if (place_.empty() && fields.size() == 3) place_ = {0, 1, 2};
    if (place_.empty())
      bad_input(here(), in_quotes(lines_.line()), "a header with columns x, y and z (--columns X,Y,Z chooses others)");
    const auto is_in_order = [&](std::size_t first) { return place_[first] == first; };
    for (std::size_t i = 0; i < place_.size(); ++i) {
      if (is_in_order(i)) continue;
      std::string names;
      for (const std::size_t place : place_) names += (names.empty() ? "" : ", ") + in_quotes(fields[place]);
      file_.remarks.push_back("the columns " + names + " are read, as the header says (--columns chooses others)");
      break;
    }
  }

  /// A point takes six characters or more; room that is not used costs nothing.
  void reserve() {
    const std::string_view rest = lines_.rest();
    const std::size_t count = std::min(count_line_ends(rest) + 2, rest.size() / 6 + 2);
    reserve_points(file_, count, has_normals_, false);
  }

  /// The point of the current line, if it counts.
  void take_line() {
    const auto read = [this](Fields& fields) { return read_number(fields, of_where); };
    const auto take = [this](std::size_t count) { take_width(count); };
    if (selection_.is_selected(Fields(lines_.line(), separator_), read, take)) read_point();
  }

  void take_width(std::size_t count) {
    if (width_ == 0) width_ = count;
    if (count != width_)
      bad_input(here(), found_columns(count), std::to_string(width_) + " as in line " + std::to_string(first_line_));
  }

  void read_point() {
    Fields fields(lines_.line(), separator_);
    std::array<double, 6> value{};
    std::array<std::string_view, 3> color;
    std::size_t count = 0;
    for (; !fields.at_end(); ++count) {
      if (count < role_.size() && role_[count] != none) {
        if (role_[count] < first_color)
          value[role_[count]] = read_number(fields);
        else
          color[role_[count] - first_color] = without_quotes(fields.take());
      } else {
        fields.take();
      }
    }
    take_width(count);
    const Point3 normal{value[3], value[4], value[5]};
    if (unnamed_ && by_content_) {
      take_unnamed(normal);
    } else if (has_normals_ && normal == Point3{}) {
      bad_input(here(), "a normal of length 0", "one of another length" + selection_.hint());
    }
    if (has_colors_) colors_.take(color, lines_.number());
    file_.points.push_back({value[0], value[1], value[2]});
    if (has_normals_) file_.normals.push_back(normal);
  }

  void take_unnamed(const Point3& value) {
    no_direction_ = no_direction_ || value == Point3{};
    for (const double channel : {value.x, value.y, value.z}) {
      all_channels_ = all_channels_ && channel >= 0 && channel <= greatest_channel && std::trunc(channel) == channel;
      greatest_ = std::max(greatest_, channel);
    }
  }

  /// `where`, for messages, is empty for what is read of a point.
  double read_number(Fields& fields, std::string_view where = {}) {
    const ParsedNumber number = parse_number(fields.begin_of_field(), fields.end_of_line());
    if (number.fault == NumberFault::none && !comma_.is_used() && fields.take_up_to(number.end)) {
      all_whole_ = all_whole_ && std::trunc(number.value) == number.value;
      return number.value;
    }
    const std::string_view field = without_quotes(fields.take());
    if (separator_ != ',' && field.find(',') != std::string_view::npos) {
      const double value = comma_.read(field, here());
      if (!comma_.is_used()) comma_.begin(field, lines_.number(), all_whole_, here(), file_.remarks);
      return value;
    }
    comma_.refuse_point(field, here());
    const ParsedNumber whole = parse_whole_number(field);
    if (whole.fault != NumberFault::none)
      bad_input(here(), in_quotes(field),
                expected_instead(whole.fault) + std::string(where) +
                    (is_missing(field) || !where.empty() ? selection_.hint() : std::string()));
    all_whole_ = all_whole_ && std::trunc(whole.value) == whole.value;
    return whole.value;
  }

  static constexpr std::size_t none = ~std::size_t{0}, first_color = 6;  // in place_
  static constexpr double greatest_channel = 65535;

  Lines lines_;
  const std::string& name_;
  const std::optional<std::vector<Column>>& columns_;
  LineSelection selection_;
  SpacePoints file_ = {};
  std::vector<std::size_t> place_ = {};  // columns of x, y, z, those of the normal, and those of colours
  std::vector<std::size_t> role_ = {};   // which of these a column is
  std::size_t first_line_ = 0;           // the line that says how many columns there are
  std::size_t width_ = 0;                // how many; 0: not known yet
  char separator_ = blanks;
  bool all_whole_ = true;  // the numbers without a comma so far
  DecimalComma comma_ = {};
  TextColors colors_ = TextColors(greatest_channel);
  bool has_normals_ = false, has_colors_ = false, degrees_ = false;
  bool unnamed_ = false, by_content_;  // whether columns 4 to 6 have no names, and what they are is to be seen
  bool all_channels_ = true;           // these are whole numbers of a channel so far
  bool no_direction_ = false;          // one of them is no normal
  double greatest_ = 0;
};

}  // namespace

SpacePoints read_space_table(std::string_view text, const std::string& name, const SpaceChoice& choice) {
  if (std::optional<SpacePoints> file = SpaceTable(text, name, choice, Unnamed::by_content).read())
    return std::move(*file);
  // A line without a normal is refused, or left out.
  return *SpaceTable(text, name, choice, Unnamed::normals).read();
}

}  // namespace rbpa::app
