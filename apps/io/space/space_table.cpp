#include <algorithm>
#include <array>
#include <cmath>

#include "io/failure.h"
#include "io/number.h"
#include "io/space/readers.h"
#include "io/table/decimal_comma.h"
#include "io/table/field_text.h"
#include "io/table/fields.h"
#include "io/table/header.h"
#include "io/table/line_selection.h"
#include "io/table/separator.h"

namespace rbpa::app {
namespace {

class SpaceTable {
 public:
  SpaceTable(std::string_view text, const std::string& name, const SpaceChoice& choice)
      : lines_(beyond_byte_order_mark(text, name)),
        name_(name),
        columns_(choice.columns),
        selection_(choice.where, choice.skip_invalid) {}

  SpacePoints read() {
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
    }
    const bool header = is_by_name() || is_header(fields, place_);
    if (header) width_ = fields.size();
    role_.assign(*std::max_element(place_.begin(), place_.end()) + 1, none);
    for (std::size_t i = 0; i < place_.size(); ++i) role_[place_[i]] = i;
    return header;
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
    reserve_points(file_, count, place_.size() == 6, false);
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
    std::size_t count = 0;
    for (; !fields.at_end(); ++count) {
      if (count < role_.size() && role_[count] != none) {
        value[role_[count]] = read_number(fields);
      } else {
        fields.take();
      }
    }
    take_width(count);
    const Point3 normal{value[3], value[4], value[5]};
    if (place_.size() == 6 && normal == Point3{})
      bad_input(here(), "a normal of length 0", "one of another length" + selection_.hint());
    file_.points.push_back({value[0], value[1], value[2]});
    if (place_.size() == 6) file_.normals.push_back(normal);
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

  static constexpr std::size_t none = ~std::size_t{0};

  Lines lines_;
  const std::string& name_;
  const std::optional<std::vector<Column>>& columns_;
  LineSelection selection_;
  SpacePoints file_ = {};
  std::vector<std::size_t> place_ = {};  // columns of x, y, z, and those of the normal
  std::vector<std::size_t> role_ = {};   // which of these a column is
  std::size_t first_line_ = 0;           // the line that says how many columns there are
  std::size_t width_ = 0;                // how many; 0: not known yet
  char separator_ = blanks;
  bool all_whole_ = true;  // the numbers without a comma so far
  DecimalComma comma_ = {};
};

}  // namespace

SpacePoints read_space_table(std::string_view text, const std::string& name, const SpaceChoice& choice) {
  return SpaceTable(text, name, choice).read();
}

}  // namespace rbpa::app
