#include "triangulation/hole_choice.h"

#include <charconv>
#include <string_view>

#include "io/bytes/number.h"
#include "io/failure.h"

namespace rbpa::app {

HoleChoice parse_fill_holes(const std::string& text) {
  constexpr std::string_view length = "length=";
  HoleChoice choice;
  choice.rims = text == "rims";
  if (text == "all" || choice.rims) return choice;
  if (text.starts_with(length)) {
    const ParsedNumber number = parse_whole_number(std::string_view(text).substr(length.size()));
    choice.most_length = number.value;
    if (number.fault == NumberFault::none && number.value > 0) return choice;
  } else {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), choice.most_edges);
    if (error == std::errc() && end == text.data() + text.size() && choice.most_edges >= 3) return choice;
  }
  throw WrongUsage("--fill-holes: found " + in_quotes(text) +
                   ", expected all, rims, a number of edges from 3, such as 30, or a length, such as length=2.5");
}

}  // namespace rbpa::app
