#include "io/polygon/attributes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/number.h"
#include "io/words.h"

namespace rbpa::app {
namespace {

/// Returns the value of a feature as text for JSON or CSV, a number as the shortest text that reads back to it.
std::string value_text(const Attribute& attribute, std::size_t feature, bool json) {
  std::string text = json ? "null" : "";
  attribute.with_value(feature, [&](const auto& value) {
    char digits[number_room];
    if constexpr (requires { value.c_str(); })
      text = json ? json_text(value) : csv_text(value);
    else if (!json || std::isfinite(static_cast<double>(value)))
      text = {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
  });
  return text;
}

}  // namespace

std::vector<Attribute> attributes_of(std::span<const PointColumn> columns, std::vector<std::string> taken) {
  std::vector<Attribute> attributes;
  for (const PointColumn& column : columns) {
    taken.push_back(untaken(column.name, [&](const std::string& name) {
      return std::any_of(taken.begin(), taken.end(), [&](const auto& other) { return same_letters(name, other); });
    }));
    attributes.push_back({taken.back(), view_of(column)});
  }
  return attributes;
}

std::string json_text(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string csv_names(std::span<const Attribute> attributes) {
  std::string names;
  for (const Attribute& attribute : attributes) names.append(",").append(csv_text(attribute.name));
  return names;
}

std::string csv_values(std::span<const Attribute> attributes, std::size_t feature) {
  std::string values;
  for (const Attribute& attribute : attributes) values.append(",").append(value_text(attribute, feature, false));
  return values;
}

std::string json_members(std::span<const Attribute> attributes, std::size_t feature) {
  std::string members;
  for (const Attribute& attribute : attributes)
    members.append(",").append(json_text(attribute.name)).append(":").append(value_text(attribute, feature, true));
  return members;
}

}  // namespace rbpa::app
