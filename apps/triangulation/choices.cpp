#include "triangulation/choices.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "io/words.h"

namespace rbpa::app {
namespace {

/// Returns the number in a text such as "length=2.5", where `name` is "length="; NaN if the rest is no number, and
/// nothing if the text does not begin with `name`.
std::optional<double> named_number(std::string_view text, std::string_view name) {
  if (!text.starts_with(name)) return std::nullopt;
  const ParsedNumber number = parse_whole_number(text.substr(name.size()));
  return number.fault == NumberFault::none ? number.value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

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
  if (const std::optional<double> area = named_number(text, "area=")) {
    if (*area > 0) {
      choice.min_area = *area;
      return;
    }
  } else if (const std::optional<std::size_t> count = parse_count(text); count && *count > 0) {
    choice.min_triangles = *count;
    return;
  }
  bad_usage("--drop-small", in_quotes(text), "a number of triangles, such as 50, or an area, such as area=2.5");
}

HoleChoice parse_fill_holes(const std::string& text) {
  HoleChoice choice;
  choice.rims = text == "rims";
  if (text == "all" || choice.rims) return choice;
  if (const std::optional<double> length = named_number(text, "length=")) {
    choice.most_length = *length;
    if (*length > 0) return choice;
  } else {
    choice.most_edges = parse_count(text).value_or(0);
    if (choice.most_edges >= 3) return choice;
  }
  bad_usage("--fill-holes", in_quotes(text),
            "all, rims, a number of edges from 3, such as 30, or a length, such as length=2.5");
}

std::string rounded_up(double value) {
  const std::string nearest = rounded(value, 6);
  return parse_whole_number(nearest).value >= value ? nearest : rounded(value * 1.00001, 6);
}

DecimationOptions parse_decimation(const std::string& option, const std::string& text) {
  DecimationOptions choice;
  choice.error = named_number(text, "error=");
  if (choice.error) {
    if (*choice.error >= 0) return choice;
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
