#include "triangulation/component_choice.h"

#include <charconv>

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
      choice.least_area = number.value;
      return;
    }
  } else if (const std::optional<std::size_t> count = whole_number(text); count && *count > 0) {
    choice.least_triangles = *count;
    return;
  }
  throw WrongUsage("--drop-small: found " + in_quotes(text) +
                   ", expected a number of triangles, such as 50, or an area, such as area=2.5");
}

std::vector<bool> kept_components(const SurfaceComponents& components, const std::vector<bool>& outer,
                                  const ComponentChoice& choice) {
  std::size_t left = choice.largest.value_or(components.all.size());
  if (choice.shell == ShellChoice::largest) left = 1;
  std::vector<bool> kept;
  for (std::size_t c = 0; c < components.all.size(); ++c) {  // components are sorted by descending area
    const SurfaceComponent& component = components.all[c];
    const bool is_wanted = (choice.shell == ShellChoice::all || outer[c]) &&
                           component.triangles >= choice.least_triangles && component.area >= choice.least_area;
    kept.push_back(is_wanted && left > 0);
    left -= kept.back();
  }
  return kept;
}

}  // namespace rbpa::app
