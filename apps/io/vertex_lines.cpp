#include "io/vertex_lines.h"

#include "io/failure.h"
#include "io/number.h"

namespace rbpa::app {

double take_coordinate(std::string_view& rest, const Lines& lines, const std::string& name) {
  const std::string_view word = take_word(rest);
  if (word.empty()) bad_input(at_line(name, lines.number()), in_quotes(lines.line()), "another number");
  const ParsedNumber number = parse_whole_number(word);
  if (number.fault != NumberFault::none)
    bad_input(at_line(name, lines.number()), in_quotes(word), expected_instead(number.fault));
  return number.value;
}

}  // namespace rbpa::app
