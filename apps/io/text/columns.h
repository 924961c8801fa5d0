// What: finds the columns of x and y, or of x, y, z, a normal and a color in a table: by number, or by name, requested
//       or common.
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

/// Throws WrongUsage that says that `columns`, a text, has one column twice.
[[noreturn]] void refuse_repeated_column(std::string_view columns, const std::string& expected = "different columns");

/// Parses "X,Y", two different columns, each by its number from 1 or its name; "GEOMETRY", one column; or, if
/// `may_have_z`, "X,Y,Z". Throws WrongUsage.
std::vector<Column> parse_columns(const std::string& text, bool may_have_z = false);

/// Parses "X,Y,Z" or "X,Y,Z,NX,NY,NZ", different columns, each by its number from 1 or its name. Throws WrongUsage.
std::vector<Column> parse_space_columns(const std::string& text);

struct NamedColumns {
  std::size_t x, y;  ///< indices of columns, from 0
  bool degrees;      ///< the names are those of longitude and latitude
};

/// Returns the columns whose names are a pair such as lon and lat, x and y, or easting and northing, in any order and
/// among other columns: the leftmost pair, of names in the same letter case if there are some ("x" and "y" beside "X"),
/// or else the only pair whose names have such a word ("stop_lat", "X_WGS84") or ending ("INTPTLAT"). A pair such as E
/// and N, whose names may mean other things, is returned only if there is no other pair. East and north are no pair in
/// a header with names of south and west (are_sides()).
std::optional<NamedColumns> find_coordinates(const std::vector<std::string_view>& header);

/// Returns whether the header has names of south and west, as of boxes with four sides.
bool are_sides(const std::vector<std::string_view>& header);

/// Returns the first columns for x and y by words or endings of their names, also of several pairs; empty if there are
/// none.
std::vector<std::size_t> find_likely_columns(const std::vector<std::string_view>& header);

/// Returns the indices of the columns called x, y and z, or easting, northing and height; then of nx, ny and nz if all
/// three are there. Empty if one of the first three is missing.
std::vector<std::size_t> find_space_columns(const std::vector<std::string_view>& header);

/// Returns the indices of the columns called red, green and blue, or r, g and b; empty unless all three are there.
std::vector<std::size_t> find_color_columns(const std::vector<std::string_view>& header);

/// Returns the index of the first column called z, height, elevation or the like; nothing if there is none.
std::optional<std::size_t> find_height(const std::vector<std::string_view>& header);

/// Returns whether `name` is a common name of x (axis 0), y (axis 1) or z (axis 2).
bool is_coordinate(std::string_view name, std::size_t axis);

/// Return whether `name` is a common name of a longitude, or of a latitude.
bool is_longitude(std::string_view name);
bool is_latitude(std::string_view name);

/// Returns whether a name says that west or south is positive: "Longitude (W)", "lat [°S]".
bool is_reversed(std::string_view name);

/// Returns whether a name is that of minutes or seconds: "lat_min", "lat_m", "latmin".
bool is_part_of_degree(std::string_view name);

/// Returns whether two names have different units of length in brackets or as their last words: "X [ft]", "y_m".
bool have_different_units(std::string_view a, std::string_view b);

/// Returns the index of the first column called wkt, geom, geometry or the like, of geometries in well-known text;
/// nothing if there is none.
std::optional<std::size_t> find_wkt(const std::vector<std::string_view>& header);

}  // namespace rbpa::app
