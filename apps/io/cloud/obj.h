// What: lines and numbers of Wavefront OBJ files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/text/lines.h"

namespace rbpa::app {

/// Returns the current line, joined in `room` with the lines that continue it, without the comment after it.
std::string_view take_obj_line(Lines& lines, std::string& room);

/// Calls visit(word, rest, line) for each line with content: its first word, what follows it, and its number.
template <typename Visit>
void for_each_obj_line(Lines& lines, const Visit& visit) {
  std::string room;
  while (lines.next_with_content()) {
    const std::size_t line = lines.number();  // the first of joined lines
    std::string_view rest = take_obj_line(lines, room);
    const std::string_view word = take_word(rest);
    visit(word, rest, line);
  }
}

/// Throws BadInput, naming `line` of `name`, unless `rest`, which follows the coordinates of a vertex, is empty, a
/// weight, a color or both. Refuses, for example, two vertices in one line.
void require_end_of_vertex(std::string_view rest, const std::string& name, std::size_t line);

/// Returns the index, from 0, that `text`, a part of the corner `word`, stands for: numbers count from 1, or from −1
/// back from the last of the `before` items that are there already. The item may come later in the file. Messages call
/// an item `noun`. Throws BadInput naming `line` of `name`.
std::uint32_t take_obj_number(std::string_view word, std::string_view text, std::string_view noun, std::size_t before,
                              const std::string& name, std::size_t line);

}  // namespace rbpa::app
