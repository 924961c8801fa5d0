// What: the lines and the numbers of a Wavefront OBJ file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/text/lines.h"

namespace rbpa::app {

/// The current line with all that continue it, which are joined in `room`, without a comment behind.
std::string_view take_obj_line(Lines& lines, std::string& room);

/// Calls visit(word, rest, line) for each line with content: its first word, what follows it, and its number.
template <typename Visit>
void for_each_obj_line(Lines& lines, const Visit& visit) {
  std::string room;
  while (lines.next_with_content()) {
    const std::size_t line = lines.number();  // the first of those that are continued
    std::string_view rest = take_obj_line(lines, room);
    const std::string_view word = take_word(rest);
    visit(word, rest, line);
  }
}

/// `rest`, behind the coordinates of a vertex, is a weight, a color or both. Throws BadInput naming `line` of `name`,
/// for another vertex in the same line, say.
void require_end_of_vertex(std::string_view rest, const std::string& name, std::size_t line);

/// `text`, a part of the corner `word`, as the index of one of the things called `noun`, of which `before` are there
/// already: they count from 1, or from −1 back. It may be of one that comes later. Throws BadInput naming `line` of `name`.
std::uint32_t take_obj_number(std::string_view word, std::string_view text, std::string_view noun, std::size_t before,
                              const std::string& name, std::size_t line);

}  // namespace rbpa::app
