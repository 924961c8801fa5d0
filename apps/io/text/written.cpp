#include "io/text/written.h"

#include <algorithm>
#include <iterator>

#include "io/text/fields.h"

namespace rbpa::app {
namespace {

constexpr std::string_view digits = "0123456789";

std::size_t count_digits(std::string_view text) { return std::min(text.find_first_not_of(digits), text.size()); }

/// Removes the signs of degrees, minutes and seconds from the front of `text`; returns whether there were any other
/// than blanks and colons. Sets `any` if there were any at all.
bool take_signs(std::string_view& text, bool& any) {
  constexpr std::string_view signs[] = {" ", ":", "°", "º", "'", "′", "’", "\"", "″", "”"};
  bool has_sign = false;
  for (const auto* sign = std::begin(signs); sign != std::end(signs);) {
    if (!text.starts_with(*sign)) {
      ++sign;
      continue;
    }
    text.remove_prefix(sign->size());
    any = true;
    has_sign = has_sign || sign - std::begin(signs) > 1;
    sign = std::begin(signs);
  }
  return has_sign;
}

}  // namespace

std::optional<Angle> parse_angle(std::string_view text) {
  constexpr std::string_view letters = "NSEW";
  Angle angle;
  const auto take_letter = [&](bool at_front) {
    if (text.empty() || angle.hemisphere != '\0') return;
    const char letter = at_front ? text.front() : text.back();
    if (letters.find(letter) == std::string_view::npos) return;
    angle.hemisphere = letter;
    text = trimmed(at_front ? text.substr(1) : text.substr(0, text.size() - 1));
  };
  take_letter(true);
  take_letter(false);
  angle.has_sign = angle.hemisphere != '\0';
  const bool is_negative = text.starts_with('-') || angle.hemisphere == 'S' || angle.hemisphere == 'W';
  if (text.starts_with('-') && angle.hemisphere == '\0') text.remove_prefix(1);
  // The angle is units / scale. Both are integers, so that one division rounds to the nearest double.
  double units = 0, scale = 1;
  bool any_sign = angle.has_sign, has_fraction = false;
  int parts = 0;
  for (; !text.empty(); ++parts) {
    const std::size_t size = count_digits(text);
    if (size == 0 || size > (parts == 0 ? 3U : 2U) || parts == 3 || has_fraction) return std::nullopt;
    const auto value = static_cast<double>(*parse_count(text.substr(0, size)));
    if (parts > 0 && value >= 60) return std::nullopt;
    units = parts == 0 ? value : units * 60 + value;
    if (parts > 0) scale *= 60;
    text.remove_prefix(size);
    if (text.starts_with('.') || text.starts_with(',')) {
      has_fraction = true;
      for (text.remove_prefix(1); count_digits(text) > 0; text.remove_prefix(1)) {
        units = units * 10 + (text.front() - '0');
        scale *= 10;
      }
    }
    bool is_apart = false;
    if (take_signs(text, is_apart)) angle.has_sign = true;
    any_sign = any_sign || is_apart;
    if (!text.empty() && !is_apart) return std::nullopt;
  }
  if (!any_sign || parts == 0 || units > exact_integers || scale > exact_integers) return std::nullopt;
  angle.degrees = is_negative ? -units / scale : units / scale;
  return angle;
}

std::string expected_for(std::string_view field, NumberFault fault) {
  const std::string plain = " (export the table with cells in a plain format)";
  if (fault != NumberFault::not_a_number) return expected_instead(fault);
  if (const std::optional<std::string> number = without_thousands(field))
    return "a number without signs between thousands, " + *number + plain;
  if (const std::optional<Angle> angle = parse_angle(field)) return "decimal degrees, " + text_of(angle->degrees);
  if (field == "N" || field == "S" || field == "E" || field == "W")
    return "a number, and no letter of a hemisphere in a column of its own (south and west are negative)";
  if (const std::string way = way_to_text(field); !way.empty()) return "a number" + way;
  // A number in quotes, brackets or a formula, with a unit after a blank, or with a comment.
  const std::size_t first = std::min(field.find_first_not_of("'=\"([ "), field.size());
  std::string_view number = field.substr(first);
  number = number.substr(0, number.find_first_not_of("+-.,eE0123456789"));
  while (!number.empty() && !is_digit(number.back())) number.remove_suffix(1);
  const std::string_view rest = field.substr(first + number.size());
  if (!is_number(number) || (!rest.empty() && rest.find_first_of("'\")] %#,;") != 0)) return expected_instead(fault);
  const std::size_t next = rest.find_first_of(digits);
  if (next == std::string_view::npos || rest.find('#') < next)
    return "a number without other characters, " + std::string(number) + plain;
  const bool are_two = is_number(rest.substr(next, rest.find_last_of(digits) + 1 - next));
  return are_two ? "one number in each column (remove what makes one text of both)" : expected_instead(fault);
}

std::string way_to_text(std::string_view field) {
  const bool is_hexadecimal =
      field.size() >= 42 && field.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  if (!is_hexadecimal && !field.starts_with('{')) return "";
  return " (in well-known text: ST_AsText() of PostGIS, -lco GEOMETRY=AS_WKT of ogr2ogr)";
}

std::string way_of_fields(std::string_view line, char separator, bool are_more) {
  if (!are_more && line.starts_with('"') && line.ends_with('"') && count_fields(line, separator).all == 1)
    return " (without the quotes around the whole line)";
  if (are_more && separator == ';' && line.find("SRID=") != std::string_view::npos)
    return " (with quotes around SRID=...;POINT ...)";
  const bool are_whole = line.find_first_not_of("+-,0123456789 ") == std::string_view::npos;
  return are_more && separator == ',' && are_whole ? " (with semicolons if these commas are decimal signs)" : "";
}

std::string with_way(std::string message, const std::string& way) {
  const std::size_t last = message.rfind(" (");
  const bool has_way = message.ends_with(')') && last != std::string::npos && message[last + 2] != '\'';
  if (has_way) message.pop_back();
  return message + (has_way ? "; " : " (") + way + ")";
}

}  // namespace rbpa::app
