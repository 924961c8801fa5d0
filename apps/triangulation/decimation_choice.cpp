#include "triangulation/decimation_choice.h"

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "io/words.h"

namespace rbpa::app {

std::string rounded_up(double value) {
  const std::string nearest = rounded(value, 6);
  return parse_whole_number(nearest).value >= value ? nearest : rounded(value * 1.00001, 6);
}

DecimationOptions parse_decimation(const std::string& option, const std::string& text) {
  constexpr std::string_view error = "error=";
  DecimationOptions choice;
  if (text.starts_with(error)) {
    const ParsedNumber number = parse_whole_number(std::string_view(text).substr(error.size()));
    choice.error = number.value;
    if (number.fault == NumberFault::none && number.value >= 0) return choice;
  } else if (text.ends_with('%')) {
    const ParsedNumber number = parse_whole_number(std::string_view(text).substr(0, text.size() - 1));
    choice.share = number.value / 100;
    if (number.fault == NumberFault::none && number.value > 0 && number.value <= 100) return choice;
  } else {
    choice.faces = parse_count(text).value_or(0);
    if (choice.faces > 0) return choice;
  }
  bad_usage(option, in_quotes(text),
            "a number of triangles, such as 10000, a share, such as 10%, or a distance, such as error=0.5");
}

std::string decimated_text(const Decimation& counts) {
  std::string end, last = "change the topology";
  for (const auto& [reason, what] : {std::pair(Decimation::turned, "turn a triangle over"),
                                     {Decimation::crossing, "make triangles cross"},
                                     {Decimation::too_far, "be too far"}})
    if (counts.refused.contains(reason)) end += (end.empty() ? "" : ", ") + std::exchange(last, what);
  return "decimated from " + std::to_string(counts.given) + " to " + counted(counts.left, "triangle") +
         (counts.distance ? ", at most " + rounded_up(*counts.distance) + " from those before" : "") +
         (counts.is_exhausted ? ", no further: every collapse left would " + end + (end.empty() ? "" : " or ") + last
                              : "");
}

nlohmann::ordered_json as_json(const Decimation& counts) {
  nlohmann::ordered_json refused = nlohmann::ordered_json::object();
  for (const auto& [reason, count] : counts.refused) refused[identifier(reason)] = count;
  return {{"triangles_before", counts.given},
          {"triangles", counts.left},
          {"collapses", counts.collapses},
          {"distance", counts.distance ? nlohmann::ordered_json(*counts.distance) : nlohmann::ordered_json(nullptr)},
          {"refused", refused}};
}

}  // namespace rbpa::app
