#include "triangulation/component_choice.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "io/bytes/number.h"
#include "io/failure.h"

namespace rbpa::app {
namespace {

std::optional<std::size_t> whole_number(const std::string& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

ShellChoice parse_shell(const std::string& text) {
  if (text == "all") return ShellChoice::all;
  if (text == "outer") return ShellChoice::outer;
  if (text == "largest") return ShellChoice::largest;
  throw WrongUsage("--shell: found " + in_quotes(text) + ", expected outer, largest or all");
}

std::size_t parse_keep_largest(const std::string& text) {
  const std::optional<std::size_t> count = whole_number(text);
  if (!count || *count == 0)
    throw WrongUsage("--keep-largest: found " + in_quotes(text) + ", expected a number of components, at least 1");
  return *count;
}

void parse_drop_small(const std::string& text, ComponentChoice& choice) {
  constexpr std::string_view area = "area=";
  if (text.starts_with(area)) {
    const ParsedNumber number = parse_whole_number(std::string_view(text).substr(area.size()));
    if (number.fault == NumberFault::none && number.value > 0) {
      choice.min_area = number.value;
      return;
    }
  } else if (const std::optional<std::size_t> count = whole_number(text); count && *count > 0) {
    choice.min_triangles = *count;
    return;
  }
  throw WrongUsage("--drop-small: found " + in_quotes(text) +
                   ", expected a number of triangles, such as 50, or an area, such as area=2.5");
}

}  // namespace rbpa::app
