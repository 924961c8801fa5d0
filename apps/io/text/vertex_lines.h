// What: reads coordinates and corners from the lines of ASCII mesh files.
// Law:  each function that takes words removes them from the front of `rest`, the unread part of the current line of
//       `lines`, and throws BadInput that names that line of the file `name` if the words are not what is expected.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/text/lines.h"

namespace rbpa::app {

/// Takes the next word, a finite number, and returns it. `way` is added to the refusal of nan and inf.
double take_coordinate(std::string_view& rest, const Lines& lines, const std::string& name, std::string_view way = {});

/// Takes the next word, a number, nan or inf, and returns it.
double take_number(std::string_view& rest, const Lines& lines, const std::string& name);

/// Takes the next three words, finite numbers, and returns them.
std::array<double, 3> take_position(std::string_view& rest, const Lines& lines, const std::string& name);

/// Takes a number n and then n vertex numbers below `points`, which replace the content of `corners`.
void take_corner_list(std::string_view& rest, const Lines& lines, const std::string& name, std::size_t points,
                      std::vector<std::uint32_t>& corners);

/// Returns the text for "expected …" in a message about a corner: "a vertex number from 0 to 7" for 8 points.
std::string corner_expected(std::size_t points);

}  // namespace rbpa::app
