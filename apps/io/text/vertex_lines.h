// What: coordinates and corners from the lines of ASCII mesh files.
// Law:  each takes its words from the front of `rest`, the unread part of the current line of `lines`, and throws
//       BadInput naming that line when they are something else.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/text/lines.h"

namespace rbpa::app {

/// The next word as a finite number.
double take_coordinate(std::string_view& rest, const Lines& lines, const std::string& name);

/// The next three.
std::array<double, 3> take_position(std::string_view& rest, const Lines& lines, const std::string& name);

/// A length and so many vertex numbers below `points`, which become the content of `corners`.
void take_corner_list(std::string_view& rest, const Lines& lines, const std::string& name, std::size_t points,
                      std::vector<std::uint32_t>& corners);

/// A whole word as a number ≥ 0 without sign.
std::optional<std::size_t> parse_count(std::string_view word);

/// What a corner had to be: "a vertex number from 0 to 7".
std::string corner_expected(std::size_t points);

}  // namespace rbpa::app
