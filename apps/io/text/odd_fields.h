// What: reads fields of tables that are more than a number: an angle, or a number among other characters.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/number.h"

namespace rbpa::app {

/// An angle with the letter of a hemisphere, a sign of degrees, minutes or seconds.
struct Angle {
  double degrees = 0;      ///< negative in the south and west; rounded once
  char hemisphere = '\0';  ///< N, S, E or W, or nothing
  bool has_sign = false;   ///< there is a letter or a sign of degrees, and not only blanks or colons
};

/// Returns the angle that is written as "52°34'03.07\"N", "N52.5", "-52 34.05", "52:00:12.5", "52 deg 34' 3.07\" N",
/// "52d34m03s" or "52-34-03N"; nothing for a number alone and any other text.
std::optional<Angle> parse_angle(std::string_view text);

/// Returns whether a byte from 0x80 to 0xBF, such as CP1252's degree sign, follows an ASCII character or begins the
/// text.
bool has_stray_byte(std::string_view text);

/// Returns the text for "expected …" in a message about a field in which parse_written_number() finds `fault`, with a
/// way out in brackets if there is one.
std::string expected_for(std::string_view field, NumberFault fault);

/// Returns " (…)" with the way to write geometries as text if the field is a geometry in another form: GeoJSON, or
/// bytes in hexadecimal digits; else an empty text.
std::string way_to_text(std::string_view field);

/// Returns " (…)" with the reason why `line` has more or fewer fields than others of its table, if one shows: decimal
/// commas or geometries that are split at the separator, a line that is one text in quotes, or a sign that separates
/// nothing; else an empty text.
std::string way_of_fields(std::string_view line, char separator, bool are_more);

/// Returns whether a field of the line is a latitude and a longitude: "N52 25.358 E13 21.886".
bool has_two_angles(std::string_view line);

/// Returns `message` with a way out in brackets; if the message ends with brackets around another way out, in those.
std::string with_way(std::string message, const std::string& way);

}  // namespace rbpa::app
