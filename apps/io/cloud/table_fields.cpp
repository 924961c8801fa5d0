#include "io/cloud/table_fields.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "io/text/line_selection.h"
#include "io/text/odd_fields.h"
#include "io/text/typed_words.h"

namespace rbpa::app {

void TableFields::begin(char separator, bool in_space, std::string_view header) {
  separator_ = separator;
  in_space_ = in_space;
  header_ = header;
  first_point_ = lines_.number();
}

void TableFields::begin_block(const CloudBlock& block, std::size_t numbers) {
  block_ = &block;
  numbers_ = numbers;
}

void TableFields::end_block() {
  if (separator_ != ',') all_whole_ = all_whole_ && is_block_whole();
}

bool TableFields::is_block_whole() const {
  for (std::size_t k = 0; k < numbers_; ++k)
    for (std::size_t i = 0; i < block_->count; ++i)
      if (const double value = block_->column[k][i]; std::trunc(value) != value) return false;
  return true;
}

double TableFields::read(Fields& fields, std::string_view where, std::size_t axis) {
  const ParsedNumber number = parse_number(fields.begin_of_field(), fields.end_of_line());
  const bool whole_field = number.fault == NumberFault::none && !comma_.is_used() && fields.take_up_to(number.end);
  if (whole_field) {
    if (where.empty()) all_whole_ = all_whole_ && std::trunc(number.value) == number.value;
    return number.value;
  }
  const std::string_view field = trimmed(without_quotes(fields.take()));
  if (const std::optional<Angle> angle = where.empty() && axis < 2 ? parse_angle(field) : std::nullopt)
    if (angle->has_sign || file_.degrees) {
      if (!file_.degrees && parse_written_number(field).fault == NumberFault::none)
        refuse(field, "a number such as 2.0D3, or an angle such as 2d 3'");
      return read_angle(angle->degrees, angle->hemisphere, field, axis);
    }
  if (separator_ != ',' && field.find(',') != std::string_view::npos) return read_decimal_comma(field);
  comma_.refuse_point(field, here());
  if (separator_ == ',' && field.find(',') != std::string_view::npos && is_number(field))
    refuse(field,
           "a number with a decimal point (export the table with semicolons: between commas no decimal comma is "
           "read)");
  const ParsedNumber whole = parse_written_number(field);
  if (whole.fault == NumberFault::none) return whole.value;
  const std::string expected = expected_for(field, whole.fault) + std::string(where);
  const bool may_be_elsewhere = expected == expected_instead(NumberFault::not_a_number) && !is_missing(field);
  const std::string way = may_be_elsewhere ? other_columns() : "";
  refuse(field, way.empty() ? expected : with_way(expected, way));
}

/// Throws BadInput for a field: WholeRefusal if the field shows a way of writing in which other fields may be misread.
void TableFields::refuse(std::string_view field, const std::string& expected) const {
  std::string message = here() + ": found " + in_quotes(field) + ", expected " + expected;
  if (has_two_angles(lines_.line()))
    message = with_way(message, "split the column of latitudes and longitudes into two");
  if (has_thousands(field) || has_stray_byte(field)) throw WholeRefusal(message);
  throw BadInput(message);
}

/// Returns the degrees of an angle on an axis. Throws BadInput if its hemisphere is that of the other axis.
double TableFields::read_angle(double degrees, char hemisphere, std::string_view field, std::size_t axis) {
  const std::string_view letters = axis == 0 ? "EW" : "NS";
  if (hemisphere != '\0' && letters.find(hemisphere) == std::string_view::npos)
    bad_input(here(), in_quotes(field) + (axis == 0 ? " as x" : " as y"),
              std::string(axis == 0 ? "a longitude" : "a latitude") + " (--columns chooses the order of columns)");
  if (!std::exchange(has_angles_, true))
    file_.warnings.push_back(shown(field) + " is read as decimal degrees, " + text_of(degrees));
  file_.degrees = true;
  return degrees;
}

/// Returns a number with a decimal comma. Throws BadInput if earlier numbers have a decimal point.
double TableFields::read_decimal_comma(std::string_view field) {
  if (!is_number(field)) refuse(field, expected_for(field, NumberFault::not_a_number));
  const double value = comma_.read(field, here());
  if (!comma_.is_used()) comma_.begin(field, lines_.number(), all_whole_ && is_block_whole(), here(), file_.warnings);
  return value;
}

/// Returns a hint if the current line is the first line of points in the plane and has more than two columns: to choose
/// other columns; or, if the line has no number, to leave out titles above the header.
std::string TableFields::other_columns() const {
  if (in_space_ || lines_.number() != first_point_ || count_fields(lines_.line(), separator_).all <= 2) return "";
  bool any_number = false;
  for (Fields fields(lines_.line(), separator_); !fields.at_end();) any_number = is_number(fields.take()) || any_number;
  if (!any_number) return "--skip-invalid leaves out titles above the header";
  return "--columns X,Y chooses other columns" + (header_.empty() ? "" : " of " + in_quotes(header_));
}

void TableFields::keep(std::size_t column, const std::string& name) {
  kept_.push_back(column);
  words_.emplace_back();
  file_.kept.push_back({.name = name, .type = Scalar::int64});
}

void TableFields::take_words() {
  if (kept_.empty()) return;
  for (std::string& word : words_) word.clear();
  std::size_t column = 0, k = 0;
  for (Fields fields(lines_.line(), separator_); !fields.at_end() && k < kept_.size(); ++column) {
    const std::string_view field = fields.take();
    if (column != kept_[k]) continue;
    std::string room;
    words_[k] = text_of_field(field, room);
    if (separator_ != ',' && (comma_.is_used() || all_whole_) && is_number(words_[k]))
      std::replace(words_[k].begin(), words_[k].end(), ',', '.');
    ++k;
  }
}

void TableFields::append_words() {
  for (std::size_t k = 0; k < kept_.size(); ++k) append_word(file_.kept[k], words_[k]);
}

std::string TableFields::here() const { return at_line(lines_.name(), lines_.number()); }

}  // namespace rbpa::app
