// What: finds the columns of x and y, or of x, y, z, a normal and a color in a table: by number, by name, or by common
//       names.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

/// A column by its number or by its name in the header line.
struct Column {
  std::size_t number = 0;  ///< from 1; 0 if the column has a name
  std::string name = {};
  friend bool operator==(const Column&, const Column&) = default;
};

/// Throws WrongUsage: two of `columns` are the same column.
[[noreturn]] void refuse_repeated_column(std::string_view columns, const std::string& expected = "different columns");

/// Parses "X,Y", two different columns by number, from 1, or name; or one column, of geometries. Throws WrongUsage.
std::vector<Column> parse_columns(const std::string& text);

/// Parses "X,Y,Z" or "X,Y,Z,NX,NY,NZ", different columns by number, from 1, or name. Throws WrongUsage.
std::vector<Column> parse_space_columns(const std::string& text);

struct NamedColumns {
  std::size_t x, y;  ///< from 0
  bool degrees;      ///< the columns are called longitude and latitude
};

/// Returns the columns whose names are a pair such as lon and lat, x and y, or easting and northing, in any order and
/// among other columns; the leftmost of several pairs.
std::optional<NamedColumns> find_coordinates(const std::vector<std::string_view>& header);

/// Returns the columns called x, y and z, or easting, northing and height, followed by those called nx, ny and nz if
/// all three are there; none without the first three.
std::vector<std::size_t> find_space_columns(const std::vector<std::string_view>& header);

/// Returns the columns called red, green and blue, or r, g and b, if all three are there.
std::vector<std::size_t> find_color_columns(const std::vector<std::string_view>& header);

/// Returns the column called z, height, elevation or the like.
std::optional<std::size_t> find_height(const std::vector<std::string_view>& header);

/// Returns whether a name is a common name of x, y or z: axis 0, 1 or 2.
bool is_coordinate(std::string_view name, std::size_t axis);

/// Returns whether a name is a common name of a longitude; of a latitude.
bool is_longitude(std::string_view name);
bool is_latitude(std::string_view name);

/// Returns the column of geometries in well-known text, called wkt, geom, geometry or the like.
std::optional<std::size_t> find_wkt(const std::vector<std::string_view>& header);

}  // namespace rbpa::app
