// What: fields of points: values beside coordinates, with their names and types, which a mesh keeps at its vertices.
// Law:  a value has the type that it has in the file, and its bits; 64-bit integers are exact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/scalar.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// The values of a field, one for each point.
struct PointColumn {
  std::string name;
  Scalar type = Scalar::float64;
  std::vector<char> bytes = {};         ///< the values, in the byte order of the processor
  bool is_text = false;                 ///< the values, of type int32, number `texts` from 0
  std::vector<std::string> texts = {};  ///< distinct
  std::string fault = {};               ///< why the column is left out; else empty

  const std::string& text(std::size_t i) const { return texts[static_cast<std::size_t>(value<std::int32_t>(i))]; }
  /// Returns whether a value is missing: NaN, or an empty text.
  bool is_missing(std::size_t i) const;
  std::size_t size() const { return bytes.size() / size_of(type); }
  template <typename T>
  T value(std::size_t i) const {
    return load<T>(&bytes[i * sizeof(T)], std::endian::native);
  }
  /// Appends a value. Requires: T is the type of the column.
  template <typename T>
  void append(T value) {
    bytes.insert(bytes.end(), reinterpret_cast<const char*>(&value), reinterpret_cast<const char*>(&value + 1));
  }
};

/// The fields to keep.
struct FieldChoice {
  /// Absent: all. Fields after an empty name are not required.
  std::optional<std::vector<std::string>> names = std::nullopt;

  bool has(std::string_view name) const;
};

/// Parses --fields: "all", or names with commas between them; absent for "none". Throws WrongUsage.
std::optional<FieldChoice> parse_fields(const std::string& text);

/// Returns whether two names are those of one field: the case of letters and underscores do not count, and PDAL's names
/// of fields of LAS are known.
bool is_same_field(std::string_view a, std::string_view b);

/// Removes columns with a fault, and adds a warning for each.
void settle_columns(std::vector<PointColumn>& columns, std::vector<std::string>& warnings);

/// Returns the column with exactly this name, else the first with is_same_field(); null if there is none.
const PointColumn* find_column(std::span<const PointColumn> columns, std::string_view name);

/// Returns find_column(). Throws BadInput that names the file and `option`, which requires a column, if none is there.
const PointColumn& require_column(std::span<const PointColumn> columns, std::string_view name,
                                  const std::string& option, const std::string& file);

/// Requires the columns that the choice of --fields names. Throws as require_column().
void require_fields(std::span<const PointColumn> columns, const std::optional<FieldChoice>& choice,
                    const std::string& file);

/// Appends the columns of a further file, `more`, to those of the files before, which are not `first` if there are any:
/// to each the column with its name. Numbers of several types become float64, if it holds all. A column with texts in
/// one file and numbers in another, or that a file does not have, gets a fault.
void append_columns(std::vector<PointColumn>& columns, std::vector<PointColumn> more, bool first);

/// Changes the type of a column of numbers to float64. Returns false, and changes nothing, if doubles do not represent
/// one of them.
bool become_numbers(PointColumn& column);

/// Removes, of the values after the first `before` of each column, those with kept[i − before] = 0.
void keep_values(std::vector<PointColumn>& columns, std::size_t before, std::span<const std::uint8_t> kept);

/// Appends a value for each added point: of floating-point numbers the mean of the values of the three points around
/// it; of integers and texts, which may be labels, the value of the nearest of the three.
void append_between(std::vector<PointColumn>& columns, std::span<const Point3> points,
                    std::span<const std::array<std::uint32_t, 3>> between);

/// The fields of the vertices of a mesh.
struct VertexFields {
  std::span<const PointColumn> columns = {};
  std::span<const std::uint32_t> rows = {};  ///< the point of each vertex; empty: vertex i is point i

  std::size_t row(std::size_t vertex) const { return rows.empty() ? vertex : rows[vertex]; }
};

/// Returns "a name" if `is_taken` is false for it, else the first of "a name_2", "a name_3", … for which it is.
template <typename IsTaken>
std::string untaken(const std::string& name, const IsTaken& is_taken) {
  std::string unique = name;
  for (int i = 2; is_taken(unique); ++i) unique = name + "_" + std::to_string(i);
  return unique;
}

/// Returns the numbers of texts for people: "0 = oak, 1 = elm".
std::string legend_of(const PointColumn& column);

}  // namespace rbpa::app
