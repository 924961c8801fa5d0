#include "io/cloud/table_numbers.h"

#include <cmath>
#include <optional>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "io/text/written.h"

namespace rbpa::app {

void TableNumbers::begin(char separator, bool in_space, std::string_view header) {
  separator_ = separator;
  in_space_ = in_space;
  header_ = header;
  first_point_ = lines_.number();
}

void TableNumbers::begin_block(const CloudBlock& block, std::size_t numbers) {
  block_ = &block;
  numbers_ = numbers;
}

void TableNumbers::end_block() {
  if (separator_ != ',') all_whole_ = all_whole_ && is_block_whole();
}

bool TableNumbers::is_block_whole() const {
  for (std::size_t k = 0; k < numbers_; ++k)
    for (std::size_t i = 0; i < block_->count; ++i)
      if (const double value = block_->column[k][i]; std::trunc(value) != value) return false;
  return true;
}

double TableNumbers::read(Fields& fields, std::string_view where, std::size_t axis) {
  const ParsedNumber number = parse_number(fields.begin_of_field(), fields.end_of_line());
  const bool whole_field = number.fault == NumberFault::none && !comma_.is_used() && fields.take_up_to(number.end);
  if (whole_field) {
    if (where.empty()) all_whole_ = all_whole_ && std::trunc(number.value) == number.value;
    return number.value;
  }
  const std::string_view field = trimmed(without_quotes(fields.take()));
  if (const std::optional<Angle> angle = where.empty() && axis < 2 ? parse_angle(field) : std::nullopt)
    if (angle->has_sign || file_.degrees) return read_angle(angle->degrees, angle->hemisphere, field, axis);
  if (separator_ != ',' && field.find(',') != std::string_view::npos) return read_decimal_comma(field);
  comma_.refuse_point(field, here());
  if (separator_ == ',' && field.find(',') != std::string_view::npos && is_number(field))
    bad_input(here(), in_quotes(field),
              "a number with a decimal point (export the table with semicolons: between commas no decimal comma is "
              "read)");
  const ParsedNumber whole = parse_written_number(field);
  if (whole.fault == NumberFault::none) return whole.value;
  const std::string expected = expected_for(field, whole.fault) + std::string(where);
  const bool may_be_elsewhere = whole.fault == NumberFault::not_a_number && !is_missing(field) && where.empty();
  const std::string way = may_be_elsewhere ? other_columns() : "";
  bad_input(here(), in_quotes(field), way.empty() ? expected : with_way(expected, way));
}

/// Returns the degrees of an angle on an axis. Throws BadInput if its hemisphere is that of the other axis.
double TableNumbers::read_angle(double degrees, char hemisphere, std::string_view field, std::size_t axis) {
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
double TableNumbers::read_decimal_comma(std::string_view field) {
  const double value = comma_.read(field, here());
  if (!comma_.is_used()) comma_.begin(field, lines_.number(), all_whole_ && is_block_whole(), here(), file_.warnings);
  return value;
}

/// Returns a hint to choose other columns if the current line is the first of points and has more than two columns.
std::string TableNumbers::other_columns() const {
  if (in_space_ || lines_.number() != first_point_ || count_fields(lines_.line(), separator_).all <= 2) return "";
  return "--columns X,Y chooses other columns" + (header_.empty() ? "" : " of " + in_quotes(header_));
}

std::string TableNumbers::here() const { return at_line(lines_.name(), lines_.number()); }

}  // namespace rbpa::app
