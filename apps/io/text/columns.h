// What: which columns of a table are x and y, or x, y, z, the parts of a normal and a color: by number, by name, or by
//       the names that people give them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rbpa::app {

/// A column by its number or by its name in the header line.
struct Column {
  std::size_t number = 0;  ///< from 1; 0 when the name counts
  std::string name = {};
  friend bool operator==(const Column&, const Column&) = default;
};

/// Throws WrongUsage: two of `columns` are the same.
[[noreturn]] void refuse_one_column(std::string_view columns);

/// The same of columns in space.
[[noreturn]] void refuse_repeated_column(std::string_view columns);

/// "X,Y", each a number from 1 or a name, and not the same; or one, which has geometries. Throws WrongUsage.
std::vector<Column> parse_columns(const std::string& text);

/// "X,Y,Z" or "X,Y,Z,NX,NY,NZ", each a number from 1 or a name, and no two the same. Throws WrongUsage.
std::vector<Column> parse_space_columns(const std::string& text);

struct NamedColumns {
  std::size_t x, y;  ///< from 0
  bool degrees;      ///< they are called longitude and latitude
};

/// The columns whose names are a pair such as lon and lat, x and y, easting and northing, in whatever order and with
/// whatever beside them. Of several pairs the one that begins farthest to the left.
std::optional<NamedColumns> find_coordinates(const std::vector<std::string_view>& header);

/// The columns called x, y and z, or easting, northing and height, and behind them those called nx, ny and nz when all
/// three are there; none unless there are the first three.
std::vector<std::size_t> find_space_columns(const std::vector<std::string_view>& header);

/// The columns called red, green and blue, or r, g and b, when all three are there.
std::vector<std::size_t> find_color_columns(const std::vector<std::string_view>& header);

/// The column called z, height or elevation, or the like.
std::optional<std::size_t> find_height(const std::vector<std::string_view>& header);

/// Whether such a name is one of a longitude, a latitude.
bool is_longitude(std::string_view name);
bool is_latitude(std::string_view name);

/// The column of geometries in well-known text, called wkt, geom, geometry or the like.
std::optional<std::size_t> find_wkt(const std::vector<std::string_view>& header);

}  // namespace rbpa::app
