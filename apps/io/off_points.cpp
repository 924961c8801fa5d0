#include "io/off_points.h"

#include <charconv>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/lines.h"
#include "io/number.h"
#include "io/vertex_lines.h"

namespace rbpa::app {
namespace {

/// Whether a word is OFF with the prefixes of a three-dimensional ASCII file.
bool is_keyword(std::string_view word) {
  for (const std::string_view prefix : {"ST", "C", "N"})
    if (word.substr(0, prefix.size()) == prefix) word.remove_prefix(prefix.size());
  return word == "OFF";
}

}  // namespace

std::vector<Point> read_off_points(std::string_view text, const std::string& name) {
  Lines lines(text);
  if (!lines.next_with_content()) bad_input(name, "no OFF header", "an ASCII .off file");
  std::string_view rest = lines.line();
  std::string_view after_word = rest;
  const std::string_view word = take_word(after_word);
  if (is_keyword(word)) {
    rest = trimmed(after_word);
    if (rest.substr(0, 6) == "BINARY") bad_input(at_line(name, lines.number()), "binary OFF", "ASCII OFF");
    if (rest.empty() || rest.front() == '#') rest = lines.next_with_content() ? lines.line() : std::string_view();
  } else if (parse_whole_number(word).fault != NumberFault::none) {
    bad_input(at_line(name, lines.number()), in_quotes(word), "OFF, COFF, NOFF or CNOFF");
  }
  const std::size_t counts_line = lines.number();
  const std::string_view counts_text = rest;
  std::size_t count = 0;
  const std::string_view number = take_word(rest);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), count);
  if (error != std::errc() || end != number.data() + number.size())
    bad_input(at_line(name, counts_line), in_quotes(counts_text), "the numbers of vertices, faces and edges");
  const std::string announced = counted(count, "vertex line") + " as line " + std::to_string(counts_line) + " says";
  // The shortest vertex line is "0 0" and its end, but for the last.
  if (count > (lines.rest().size() + 1) / 4) bad_input(name, counted(lines.rest().size(), "byte") + " of data", announced);

  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    if (!lines.next_with_content()) bad_input(name, counted(i, "vertex line"), announced);
    std::string_view line = lines.line();
    points[i].x = take_coordinate(line, lines, name);
    points[i].y = take_coordinate(line, lines, name);
  }
  return points;
}

}  // namespace rbpa::app
