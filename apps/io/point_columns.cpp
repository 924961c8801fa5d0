#include "io/point_columns.h"

#include <algorithm>
#include <cmath>

#include "io/failure.h"
#include "io/number.h"
#include "io/words.h"

namespace rbpa::app {

bool FieldChoice::has(std::string_view name) const {
  return !names || std::any_of(names->begin(), names->end(),
                               [&](const std::string& wanted) { return same_letters(wanted, name); });
}

std::optional<FieldChoice> parse_fields(const std::string& text) {
  if (text == "none") return std::nullopt;
  if (text == "all") return FieldChoice{};
  std::vector<std::string> names;
  for (const std::string_view word : split_at_commas(text)) {
    if (word.empty()) bad_usage("--fields", in_quotes(text), "names of fields with commas between them, all or none");
    names.emplace_back(word);
  }
  return FieldChoice{std::move(names)};
}

void settle_columns(std::vector<PointColumn>& columns, const FieldChoice& choice, const std::string& name,
                    std::vector<std::string>& warnings) {
  std::vector<std::string> there;
  for (const PointColumn& column : columns) {
    there.push_back(in_quotes(column.name));
    if (!column.fault.empty()) warnings.push_back("field " + in_quotes(column.name) + " is left out: " + column.fault);
  }
  for (const std::string& wanted : choice.names.value_or(std::vector<std::string>()))
    if (std::none_of(columns.begin(), columns.end(),
                     [&](const PointColumn& column) { return same_letters(column.name, wanted); }))
      bad_input(name, "no field " + in_quotes(wanted) + " beside the coordinates",
                there.empty() ? "one, as --fields requires"
                              : "some of " + listed(there, " and ") + " (--fields chooses them)");
  std::erase_if(columns, [](const PointColumn& column) { return !column.fault.empty(); });
}

void keep_values(std::vector<PointColumn>& columns, std::size_t before, std::span<const std::uint8_t> kept) {
  for (PointColumn& column : columns) {
    const std::size_t size = size_of(column.type);
    if (column.bytes.size() < (before + kept.size()) * size) continue;  // the column has a fault
    std::size_t to = before;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (kept[i] != 0) std::memmove(&column.bytes[to++ * size], &column.bytes[(before + i) * size], size);
    column.bytes.resize(to * size);
  }
}

void append_between(std::vector<PointColumn>& columns, std::span<const Point3> points,
                    std::span<const std::array<std::uint32_t, 3>> between) {
  const std::size_t given = points.size() - between.size();
  for (std::size_t i = 0; i < between.size(); ++i) {
    const Point3& p = points[given + i];
    const auto distance = [&](std::uint32_t of) {
      return std::hypot(points[of].x - p.x, points[of].y - p.y, points[of].z - p.z);
    };
    const std::array<std::uint32_t, 3>& around = between[i];
    const std::uint32_t nearest = *std::min_element(
        around.begin(), around.end(), [&](std::uint32_t a, std::uint32_t b) { return distance(a) < distance(b); });
    for (PointColumn& column : columns)
      with_type(column.type, [&](auto value) {
        using Value = decltype(value);
        if constexpr (std::is_floating_point_v<Value>) {
          double sum = 0;
          for (const std::uint32_t of : around) sum += static_cast<double>(column.value<Value>(of)) / 3;
          column.append(static_cast<Value>(sum));
        } else {
          column.append(column.value<Value>(nearest));
        }
      });
  }
}

std::string legend_of(const PointColumn& column) {
  std::string legend;
  for (std::size_t i = 0; i < column.texts.size(); ++i)
    legend += (i == 0 ? "" : ", ") + std::to_string(i) + " = " + printable(column.texts[i]);
  return legend;
}

}  // namespace rbpa::app
