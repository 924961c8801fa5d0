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
  std::optional<std::vector<std::string>> names = std::nullopt;  ///< absent: all

  bool has(std::string_view name) const;
};

/// Parses --fields: "all", or names with commas between them; absent for "none". Throws WrongUsage.
std::optional<FieldChoice> parse_fields(const std::string& text);

/// Removes columns with a fault, and adds a warning for each. Throws BadInput that names the file `name` if a field of
/// the choice is not there.
void settle_columns(std::vector<PointColumn>& columns, const FieldChoice& choice, const std::string& name,
                    std::vector<std::string>& warnings);

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
