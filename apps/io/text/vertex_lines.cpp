#include "io/text/vertex_lines.h"

#include <charconv>
#include <optional>

#include "io/failure.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

void skip_blanks(std::string_view& text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
}

/// Returns whether a word of `rest` ends at `end`; if so, removes the text before `end` from `rest`.
bool take_up_to(const char* end, std::string_view& rest) {
  const auto size = static_cast<std::size_t>(end - rest.data());
  if (size == 0 || (size < rest.size() && !is_blank(rest[size]))) return false;
  rest.remove_prefix(size);
  return true;
}

}  // namespace

double take_number(std::string_view& rest, const Lines& lines, const std::string& name) {
  std::string_view after = rest;
  const ParsedNumber number = parse_written_number(take_word(after));
  if (number.fault != NumberFault::none && number.fault != NumberFault::not_finite)
    return take_coordinate(rest, lines, name);  // throws
  rest = after;
  return number.value;
}

double take_coordinate(std::string_view& rest, const Lines& lines, const std::string& name, std::string_view way) {
  skip_blanks(rest);
  const ParsedNumber coordinate = parse_number(rest.data(), rest.data() + rest.size());
  if (coordinate.fault == NumberFault::none && take_up_to(coordinate.end, rest)) return coordinate.value;
  const std::string_view word = take_word(rest);
  if (word.empty()) bad_input(at_line(name, lines.number()), in_quotes(lines.line()), "one more number");
  const ParsedNumber number = parse_written_number(word);
  if (number.fault != NumberFault::none)
    bad_input(at_line(name, lines.number()), in_quotes(word),
              expected_instead(number.fault) + std::string(number.fault == NumberFault::not_finite ? way : ""));
  return number.value;
}

std::array<double, 3> take_position(std::string_view& rest, const Lines& lines, const std::string& name) {
  std::array<double, 3> position{};
  for (double& coordinate : position) coordinate = take_coordinate(rest, lines, name);
  return position;
}

void take_corner_list(std::string_view& rest, const Lines& lines, const std::string& name, std::size_t points,
                      std::vector<std::uint32_t>& corners) {
  const std::string_view length_word = take_word(rest);
  const std::optional<std::size_t> length = parse_count(length_word);
  if (!length)
    bad_input(at_line(name, lines.number()), in_quotes(length_word.empty() ? lines.line() : length_word),
              "the number of corners of a face");
  corners.clear();
  for (std::size_t i = 0; i < *length; ++i) {
    skip_blanks(rest);
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error == std::errc() && number < points && take_up_to(end, rest)) {
      corners.push_back(number);
      continue;
    }
    const std::string_view word = take_word(rest);
    if (word.empty())
      bad_input(at_line(name, lines.number()), counted(i, "corner") + " (" + in_quotes(lines.line()) + ")",
                std::to_string(*length) + " as the line says");
    const std::optional<std::size_t> corner = parse_count(word);
    if (!corner || *corner >= points)
      bad_input(at_line(name, lines.number()), in_quotes(word), corner_expected(points));
    corners.push_back(static_cast<std::uint32_t>(*corner));
  }
}

std::string corner_expected(std::size_t points) {
  if (points == 0) return "no corner, as there are no vertices";
  return "a vertex number from 0 to " + std::to_string(points - 1);
}

}  // namespace rbpa::app
