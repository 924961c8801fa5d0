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
#include <unordered_map>
#include <vector>

#include "io/scalar.h"
#include "io/words.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// The values of a field, one for each point.
struct PointColumn {
  std::string name;
  Scalar type = Scalar::float64;
  std::vector<char> bytes = {};                                ///< the values, in the byte order of the processor
  bool is_text = false;                                        ///< the values, of type int32, are indices in `texts`
  std::vector<std::string> texts = {};                         ///< the distinct texts
  std::unordered_map<std::string, std::int32_t> numbers = {};  ///< the index of each of them
  std::string fault = {};  ///< reason why the column is left out; empty if it is not

  const std::string& text(std::size_t i) const { return texts[static_cast<std::size_t>(value<std::int32_t>(i))]; }
  /// Returns the index of a text in `texts`, to which it is appended, in UTF-8, if it is new.
  std::int32_t number_of(std::string_view text);
  /// Returns whether value number `i` is missing: NaN, or an empty text.
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
  /// Names of the fields; absent: all fields. Fields after an empty name are optional for require_fields().
  std::optional<std::vector<std::string>> names = std::nullopt;

  bool has(std::string_view name) const;
};

/// Parses --fields: "all", or names with commas between them; nothing for "none". Throws WrongUsage.
std::optional<FieldChoice> parse_fields(const std::string& text);

/// Returns whether two names mean one field. Neither underscores nor the case of letters count. PDAL's and LAStools'
/// names of LAS fields equal those of the specification.
bool is_same_field(std::string_view a, std::string_view b);

/// Removes columns with a fault, and adds a warning for each.
void settle_columns(std::vector<PointColumn>& columns, std::vector<std::string>& warnings);

/// Returns the first of `all`, which have names, with exactly this name, else with it in letters of either case, else
/// with is_same_field(); null if there is none.
template <typename Named>
const Named* find_named(std::span<const Named> all, std::string_view name) {
  using Same = bool (*)(std::string_view, std::string_view);
  for (const Same same :
       {Same([](std::string_view a, std::string_view b) { return a == b; }), Same(same_letters), Same(is_same_field)})
    for (const Named& one : all)
      if (same(name, one.name)) return &one;
  return nullptr;
}

/// Returns the column that find_named() finds.
const PointColumn* find_column(std::span<const PointColumn> columns, std::string_view name);

/// Returns the column that find_column() finds. Throws BadInput that names `file` and `option` if there is none.
const PointColumn& require_column(std::span<const PointColumn> columns, std::string_view name,
                                  const std::string& option, const std::string& file);

/// Throws as require_column() unless each field that the choice of --fields names, up to an empty name, has a column.
/// Removes columns that find_column() finds for no name of the choice: of x and X, the one whose name is given.
void require_fields(std::vector<PointColumn>& columns, const std::optional<FieldChoice>& choice,
                    const std::string& file);

/// Appends the values of `more`, the columns of another file, to `columns`, those of the files before it: to each
/// column those of the column with its name. `first`: there is no file before. Numbers of different types become
/// float64, and numbers become texts if a file has texts. A column gets a fault if doubles do not hold its numbers, or
/// if a file does not have it.
void append_columns(std::vector<PointColumn>& columns, std::vector<PointColumn> more, bool first);

/// Changes the type of a column of numbers to float64. Returns false, and changes nothing, if doubles do not represent
/// one of the numbers.
bool become_numbers(PointColumn& column);

/// Changes a column of numbers into one of their texts; NaN becomes an empty text.
void become_texts(PointColumn& column);

/// Removes value number `before` + i of each column for each i with kept[i] = 0.
void keep_values(std::vector<PointColumn>& columns, std::size_t before, std::span<const std::uint8_t> kept);

/// Appends to each column a value for each of the last between.size() points; between[i] are the three points around
/// the i-th of them. The value is the mean of the three values for floating-point numbers, and the value of the nearest
/// of the three points for integers and texts, which may be labels.
void append_between(std::vector<PointColumn>& columns, std::span<const Point3> points,
                    std::span<const std::array<std::uint32_t, 3>> between);

/// The fields of the vertices of a mesh.
struct VertexFields {
  std::span<const PointColumn> columns = {};
  std::span<const std::uint32_t> rows = {};  ///< the point of each vertex; empty: vertex i is point i

  std::size_t row(std::size_t vertex) const { return rows.empty() ? vertex : rows[vertex]; }
};

/// Returns `name` if is_taken(name) is false, else the first of "NAME_2", "NAME_3", … that is not taken.
template <typename IsTaken>
std::string untaken(const std::string& name, const IsTaken& is_taken) {
  std::string unique = name;
  for (int i = 2; is_taken(unique); ++i) unique = name + "_" + std::to_string(i);
  return unique;
}

/// Returns the text for each number of a column of texts: "0 = oak, 1 = elm".
std::string legend_of(const PointColumn& column);

}  // namespace rbpa::app
