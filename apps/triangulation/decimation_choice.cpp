#include "triangulation/decimation_choice.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "io/bytes/number.h"
#include "io/failure.h"
#include "io/words.h"

namespace rbpa::app {

DecimationChoice parse_decimation(const std::string& option, const std::string& text) {
  DecimationChoice choice;
  if (text.ends_with('%')) {
    const ParsedNumber number = parse_whole_number(std::string_view(text).substr(0, text.size() - 1));
    choice.percent = number.value;
    if (number.fault == NumberFault::none && number.value > 0 && number.value <= 100) return choice;
  } else {
    choice.faces = parse_count(text).value_or(0);
    if (choice.faces > 0) return choice;
  }
  bad_usage(option, in_quotes(text), "a number of triangles, such as 10000, or a share, such as 10%");
}

std::string decimated_text(const Decimation& counts) {
  return "decimated from " + std::to_string(counts.given) + " to " + counted(counts.left, "triangle") +
         (counts.is_exhausted ? ", no further: every collapse left would change the topology or turn a triangle over"
                              : "");
}

nlohmann::ordered_json as_json(const Decimation& counts) {
  nlohmann::ordered_json refused = nlohmann::ordered_json::object();
  for (const auto& [reason, count] : counts.refused) refused[identifier(reason)] = count;
  return {{"triangles_before", counts.given},
          {"triangles", counts.left},
          {"collapses", counts.collapses},
          {"refused", refused}};
}

}  // namespace rbpa::app
