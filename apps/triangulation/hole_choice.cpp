#include "triangulation/hole_choice.h"

#include <string_view>

#include "io/failure.h"
#include "io/number.h"
#include "io/words.h"

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
    choice.most_edges = parse_count(text).value_or(0);
    if (choice.most_edges >= 3) return choice;
  }
  bad_usage("--fill-holes", in_quotes(text),
            "all, rims, a number of edges from 3, such as 30, or a length, such as length=2.5");
}

}  // namespace rbpa::app
