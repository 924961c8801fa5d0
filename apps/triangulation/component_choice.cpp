#include "triangulation/component_choice.h"

#include <optional>
#include <string_view>

#include "io/failure.h"
#include "io/number.h"
#include "io/words.h"

namespace rbpa::app {

ShellChoice parse_shell(const std::string& text) {
  if (text == "all") return ShellChoice::all;
  if (text == "outer") return ShellChoice::outer;
  if (text == "largest") return ShellChoice::largest;
  bad_usage("--shell", in_quotes(text), "outer, largest or all");
}

std::size_t parse_keep_largest(const std::string& text) {
  return parse_whole("--keep-largest", text, {.least = 1}, "components");
}

void parse_drop_small(const std::string& text, ComponentChoice& choice) {
  constexpr std::string_view area = "area=";
  if (text.starts_with(area)) {
    const ParsedNumber number = parse_whole_number(std::string_view(text).substr(area.size()));
    if (number.fault == NumberFault::none && number.value > 0) {
      choice.min_area = number.value;
      return;
    }
  } else if (const std::optional<std::size_t> count = parse_count(text); count && *count > 0) {
    choice.min_triangles = *count;
    return;
  }
  bad_usage("--drop-small", in_quotes(text), "a number of triangles, such as 50, or an area, such as area=2.5");
}

}  // namespace rbpa::app
