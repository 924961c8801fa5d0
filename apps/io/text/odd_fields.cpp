#include "io/text/odd_fields.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include "io/text/fields.h"

namespace rbpa::app {
namespace {

constexpr std::string_view digits = "0123456789";

std::size_t count_digits(std::string_view text) { return std::min(text.find_first_not_of(digits), text.size()); }

/// Removes the signs of degrees, minutes or seconds (`part` 0 to 2) from the front of `text`; returns whether there
/// were any other than blanks, colons and, `before_letter`, minus signs. Sets `any` if there were any at all.
bool take_signs(std::string_view& text, int part, bool before_letter, bool& any) {
  constexpr std::string_view signs[] = {" ", ":", "-", "°", "º", "˚", "'", "′", "’", "\"", "″", "”"};
  constexpr std::string_view words[3][2] = {{"deg", "d"}, {"min", "m"}, {"sec", "s"}};
  constexpr std::size_t separators = 3;  // number of first signs that may be between other numbers
  bool has_sign = false;
  const auto take = [&](std::string_view sign) {
    const bool is_there = same_letters(text.substr(0, sign.size()), sign);
    if (is_there) text.remove_prefix(sign.size());
    return is_there;
  };
  for (bool more = true; more; any = any || more) {
    more = false;
    for (std::size_t i = 0; i < std::size(signs) && !more; ++i) {
      more = (signs[i] != "-" || before_letter) && take(signs[i]);
      has_sign = has_sign || (more && i >= separators);
    }
    if (!more && !has_sign && (more = take(words[part][0]) || take(words[part][1]))) has_sign = true;
  }
  return has_sign;
}

/// Returns the angle as parse_angle() does, with minutes and seconds below `limit`.
std::optional<Angle> parse_angle(std::string_view text, double limit) {
  Angle angle;
  const auto take_letter = [&](bool at_front) {
    if (text.empty() || angle.hemisphere != '\0') return;
    const char letter = at_front ? text.front() : text.back();
    const bool may_be_second = letter == 's' && text.find_first_of("dDmM") != std::string_view::npos;
    const std::string_view letters = at_front || may_be_second ? "NSEW" : "NSEWnsew";  // e2 is a name
    if (letters.find(letter) == std::string_view::npos) return;
    angle.hemisphere = in_capitals({&letter, 1}).front();
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
    if (parts > 0 && value >= limit) return std::nullopt;
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
    if (take_signs(text, parts, angle.hemisphere != '\0', is_apart)) angle.has_sign = true;
    any_sign = any_sign || is_apart;
    if (!text.empty() && !is_apart) return std::nullopt;
  }
  if (!any_sign || parts == 0 || units > exact_integers || scale > exact_integers) return std::nullopt;
  angle.degrees = is_negative ? -units / scale : units / scale;
  return angle;
}

}  // namespace

std::optional<Angle> parse_angle(std::string_view text) { return parse_angle(text, 60); }

bool has_stray_byte(std::string_view text) {
  unsigned char before = 0;
  for (const char c : text)
    if (const auto byte = static_cast<unsigned char>(c);
        std::exchange(before, byte) < 0x80 && byte >= 0x80 && byte < 0xC0)
      return true;
  return false;
}

std::string expected_for(std::string_view field, NumberFault fault) {
  const std::string plain = " (export the table with cells in a plain format)";
  if (fault != NumberFault::not_a_number) return expected_instead(fault);
  if (has_stray_byte(field)) return "a number in UTF-8 (iconv -f CP1252 -t UTF-8)";
  if (const std::optional<std::string> number = without_thousands(field))
    return "a number without signs between thousands, " + *number + plain;
  if (const std::optional<Angle> angle = parse_angle(field)) return "decimal degrees, " + text_of(angle->degrees);
  if (const std::optional<Angle> angle = parse_angle(field, 100); angle && angle->has_sign)
    return "minutes and seconds below 60";
  if (std::string east(field); field.starts_with('O') || field.ends_with('O')) {
    std::replace(east.begin(), east.end(), 'O', 'E');
    if (parse_angle(east)) return "E or W in place of O, which is Ost in German and Oeste or Ouest elsewhere";
  }
  if (field == "N" || field == "S" || field == "E" || field == "W")
    return "a number, and no letter of a hemisphere in a column of its own (south and west are negative)";
  if (const std::string way = way_to_text(field); !way.empty()) return "a number" + way;
  const std::string each = "one number in each column (split this column into two)";
  const std::size_t comma = std::min(field.find(','), field.size());
  if (field.find('.') < field.size() && comma < field.size() && is_number(trimmed(field.substr(0, comma))) &&
      is_number(trimmed(field.substr(comma + 1))))
    return each;
  // A number in quotes, brackets or a formula, after a name, with a unit, a sign at its end, or a comment.
  std::size_t first = 0;
  while (first < field.size() && std::isalpha(static_cast<unsigned char>(field[first])) != 0) ++first;
  if (first > 0 && !field.substr(first).starts_with(':') && !field.substr(first).starts_with('=')) first = 0;
  first = std::min(field.find_first_not_of(first > 0 ? "=: " : "'=\"([ ", first), field.size());
  std::string_view number = field.substr(first);
  number = number.substr(0, number.find_first_not_of("+-.,eE0123456789"));
  while (!number.empty() && !is_digit(number.back())) number.remove_suffix(1);
  const std::string_view rest = field.substr(first + number.size());
  const bool is_apart = rest.empty() || rest.find_first_of("'\")] %#,;") == 0 || is_word_of(rest, "m ft km cm mm");
  const bool has_minus = rest == "-" || (rest.starts_with(')') && field.starts_with('(') && is_digit(number.front()));
  if (has_minus && is_number(number)) return "a number with its sign before it, -" + std::string(number) + plain;
  if (!is_number(number) || !is_apart) return expected_instead(fault);
  const std::size_t next = rest.find_first_of(digits);
  if (next == std::string_view::npos || rest.find('#') < next)
    return "a number without other characters, " + std::string(number) + plain;
  return is_number(rest.substr(next, rest.find_last_of(digits) + 1 - next)) ? each : expected_instead(fault);
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
  if (!are_more && separator == blanks && line.find_first_of("^~:!&$/") < line.size() &&
      count_fields(line, blanks).all == 1)
    return " (between , ; | tabs or blanks)";
  const bool are_whole = line.find_first_not_of("+-,0123456789 ") == std::string_view::npos;
  return are_more && separator == ',' && are_whole ? " (with semicolons if these commas are decimal signs)" : "";
}

bool has_two_angles(std::string_view line) {
  for (const char separator : {',', ';', '\t', '|'})
    for (Fields fields(line, separator); !fields.at_end();) {
      const std::string_view field = without_quotes(fields.take());
      for (const std::size_t at : {field.find_first_of("EW"), field.find_first_of("NS", 1) + 1})
        if (at > 0 && at < field.size() && parse_angle(trimmed(field.substr(0, at))) &&
            parse_angle(trimmed(field.substr(at))))
          return true;
    }
  return false;
}

std::string with_way(std::string message, const std::string& way) {
  const std::size_t last = message.rfind(" (");
  const bool has_way = message.ends_with(')') && last != std::string::npos && message[last + 2] != '\'';
  if (has_way) message.pop_back();
  return message + (has_way ? "; " : " (") + way + ")";
}

}  // namespace rbpa::app
