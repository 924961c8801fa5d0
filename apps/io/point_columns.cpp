#include "io/point_columns.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "io/failure.h"
#include "io/number.h"
#include "io/utf8.h"
#include "io/words.h"

namespace rbpa::app {

namespace {

/// Returns a name in small letters without underscores. A PDAL or LAStools name becomes that of LAS.
std::string folded_name(std::string_view name) {
  std::string result;
  for (const char c : name)
    if (c != '_') result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (result == "nir") return "infrared";
  if (result == "class") return "classification";
  if (result == "scananglerank") return "scanangle";
  if (result == "keypoint" || result == "modelkeypoint") return "keypoint";
  return result;
}

}  // namespace

std::int32_t PointColumn::number_of(std::string_view text) {
  const auto [place, is_new] = numbers.try_emplace(as_utf8(text), static_cast<std::int32_t>(texts.size()));
  if (is_new) texts.push_back(place->first);
  return place->second;
}

bool PointColumn::is_missing(std::size_t i) const {
  if (is_text) return text(i).empty();
  return with_type(type, [&](auto zero) { return std::isnan(static_cast<double>(value<decltype(zero)>(i))); });
}

bool is_same_field(std::string_view a, std::string_view b) { return folded_name(a) == folded_name(b); }

bool FieldChoice::has(std::string_view name) const {
  return !names || std::any_of(names->begin(), names->end(),
                               [&](const std::string& wanted) { return is_same_field(wanted, name); });
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

void settle_columns(std::vector<PointColumn>& columns, std::vector<std::string>& warnings) {
  for (const PointColumn& column : columns)
    if (!column.fault.empty()) warnings.push_back("field " + in_quotes(column.name) + " is left out: " + column.fault);
  std::erase_if(columns, [](const PointColumn& column) { return !column.fault.empty(); });
}

const PointColumn* find_column(std::span<const PointColumn> columns, std::string_view name) {
  return find_named(columns, name);
}

const PointColumn& require_column(std::span<const PointColumn> columns, std::string_view name,
                                  const std::string& option, const std::string& file) {
  if (const PointColumn* const found = find_column(columns, name)) return *found;
  std::vector<std::string> there;
  for (const PointColumn& column : columns) there.push_back(in_quotes(column.name));
  const bool is_axis = is_word_of(name, "x y z");
  bad_input(file,
            (is_axis ? in_quotes(name) + ", a coordinate, in place of a field"
                     : "no field " + in_quotes(name) + " beside the coordinates"),
            there.empty() ? "one, as " + option + " requires"
                          : "some of " + listed(there, " and ") + " (" + option + " chooses them)");
}

void require_fields(std::vector<PointColumn>& columns, const std::optional<FieldChoice>& choice,
                    const std::string& file) {
  if (!choice || !choice->names) return;
  for (auto name = choice->names->begin(); name != choice->names->end() && !name->empty(); ++name)
    require_column(columns, *name, "--fields", file);
  std::vector<bool> is_chosen(columns.size(), false);
  for (const std::string& name : *choice->names)
    if (const PointColumn* const found = find_column(columns, name))
      is_chosen[static_cast<std::size_t>(found - columns.data())] = true;
  std::erase_if(columns, [&](const PointColumn& column) {
    return !is_chosen[static_cast<std::size_t>(&column - columns.data())];
  });
}

bool become_numbers(PointColumn& column) {
  PointColumn numbers{.name = column.name};
  const bool all_fit = with_type(column.type, [&](auto zero) {
    for (std::size_t i = 0; i < column.size(); ++i) {
      const auto value = column.value<decltype(zero)>(i);
      if (!is_exact_in_double(value)) return false;
      numbers.append(static_cast<double>(value));
    }
    return true;
  });
  if (all_fit) column = std::move(numbers);
  return all_fit;
}

void become_texts(PointColumn& column) {
  PointColumn texts{.name = column.name, .type = Scalar::int32, .is_text = true};
  with_type(column.type, [&](auto zero) {
    using Value = decltype(zero);
    for (std::size_t i = 0; i < column.size(); ++i) {
      const auto value = column.value<Value>(i);
      if constexpr (std::is_integral_v<Value>)
        texts.append(texts.number_of(std::to_string(value)));
      else
        texts.append(texts.number_of(std::isnan(value) ? "" : text_of(static_cast<double>(value))));
    }
  });
  column = std::move(texts);
}

namespace {

/// Appends the values of `more`, a column of the same type. Texts are numbered anew, by the texts of `column`.
void append_values(PointColumn& column, const PointColumn& more) {
  if (!column.is_text) {
    column.bytes.insert(column.bytes.end(), more.bytes.begin(), more.bytes.end());
    return;
  }
  for (std::size_t i = 0; i < more.size(); ++i) column.append(column.number_of(more.text(i)));
}

}  // namespace

void append_columns(std::vector<PointColumn>& columns, std::vector<PointColumn> more, bool first) {
  const std::string missing = "not all files have it";
  for (PointColumn& column : columns) {
    const auto other =
        std::find_if(more.begin(), more.end(), [&](const PointColumn& one) { return one.name == column.name; });
    if (other == more.end()) {
      column.fault = missing;
      continue;
    }
    if (column.is_text != other->is_text)
      become_texts(column.is_text ? *other : column);
    else if (column.type != other->type && !(become_numbers(column) && become_numbers(*other)))
      column.fault = "no type holds its numbers of all files";
    if (column.fault.empty()) append_values(column, *other);
    more.erase(other);
  }
  for (PointColumn& column : more) {
    if (!first) column.fault = missing;
    columns.push_back(std::move(column));
  }
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
      // A quarter of the distance, which cannot overflow.
      return std::hypot(points[of].x / 4 - p.x / 4, points[of].y / 4 - p.y / 4, points[of].z / 4 - p.z / 4);
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
