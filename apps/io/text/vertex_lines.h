// What: reads coordinates and corners from the lines of ASCII mesh files.
// Law:  each function takes its words from the front of `rest`, the unread part of the current line of `lines`, and
//       throws BadInput naming that line if they do not fit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/text/lines.h"

namespace rbpa::app {

/// Takes the next word, a finite number.
double take_coordinate(std::string_view& rest, const Lines& lines, const std::string& name);

/// Takes the next three words, finite numbers.
std::array<double, 3> take_position(std::string_view& rest, const Lines& lines, const std::string& name);

/// Takes a length n and n vertex numbers below `points`, which replace the content of `corners`.
void take_corner_list(std::string_view& rest, const Lines& lines, const std::string& name, std::size_t points,
                      std::vector<std::uint32_t>& corners);

/// Returns what messages expect of a corner: "a vertex number from 0 to 7".
std::string corner_expected(std::size_t points);

}  // namespace rbpa::app
