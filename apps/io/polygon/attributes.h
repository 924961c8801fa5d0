// What: fields of points as attributes of features: columns of CSV, properties of GeoJSON, fields of OGR.
// Law:  numbers read back to the same values, and 64-bit integers are exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/point_columns.h"

namespace rbpa::app {

/// The values of a field at features.
struct Attribute {
  static constexpr std::uint32_t no_row = std::numeric_limits<std::uint32_t>::max();

  std::string name;
  std::shared_ptr<const PointColumn> column;
  std::vector<std::uint32_t> rows =
      {};  ///< place of the value of each feature, or no_row; empty: feature i has value i

  /// Calls use(value) with the value of a feature, a number or a text (std::string), unless it is missing.
  template <typename Use>
  void with_value(std::size_t feature, const Use& use) const {
    const std::size_t row = rows.empty() ? feature : rows[feature];
    if (row == no_row || column->is_missing(row)) return;
    if (column->is_text) return use(column->text(row));
    with_type(column->type, [&](auto zero) { use(column->value<decltype(zero)>(row)); });
  }
};

/// Returns a pointer that does not own the column.
inline std::shared_ptr<const PointColumn> view_of(const PointColumn& column) {
  return {std::shared_ptr<void>(), &column};
}

/// Returns an attribute for each column, with the column's name. A name that an earlier column or `taken` already has,
/// in letters of either case, gets a suffix _2, _3 and so on. The attributes view the columns.
std::vector<Attribute> attributes_of(std::span<const PointColumn> columns, std::vector<std::string> taken);

/// Returns a text in quotes for JSON. Bytes that are not UTF-8, such as Latin-1, are written as the replacement
/// character.
std::string json_text(std::string_view text);

/// Returns ",NAME" for each attribute, and ",VALUE" for the values of a feature; a missing value is an empty field.
std::string csv_names(std::span<const Attribute> attributes);
std::string csv_values(std::span<const Attribute> attributes, std::size_t feature);
/// Returns `,"NAME":VALUE` for each attribute; null for a missing value and for infinity.
std::string json_members(std::span<const Attribute> attributes, std::size_t feature);

}  // namespace rbpa::app
