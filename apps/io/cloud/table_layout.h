// What: which columns of a table are which, by its first line and by the request.
// Law:  a first line without a number in any column that counts is a header; where its names are known, such as lat and lon,
//       they say which columns are x and y, or that there is one of geometries in well-known text. In space a comment right
//       before the first line of numbers is a header as well, if it has as many names and x, y and z are among them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/table_lines.h"

namespace rbpa::app {

/// What the ending of its name says of a table without a header.
enum class TableKind {
  any,
  pts,     ///< x y z, with an intensity, with red green blue, or with both
  xyzn,    ///< x y z nx ny nz
  xyzrgb,  ///< x y z red green blue
  atoms    ///< atom_columns
};

/// Of an atom: its place, and what conditions may ask for; "?" where the file has nothing.
inline constexpr std::array<std::string_view, 12> atom_columns = {
    "x", "y", "z", "serial", "name", "altloc", "resname", "chain", "resseq", "occupancy", "bfactor", "element"};

struct TableLayout {
  bool header = false;                    ///< the first line is one
  std::size_t width = 0;                  ///< its fields
  std::vector<std::size_t> numbers = {};  ///< the columns of x, y; or of x, y, z and, if it has six, of the normal
  std::vector<std::size_t> colors = {};   ///< none, or those of red, green and blue
  std::optional<std::size_t> wkt = std::nullopt;  ///< that of geometries, in place of x and y
  std::optional<std::size_t> height = std::nullopt;
  bool degrees = false;                      ///< x is a longitude and y a latitude
  bool unnamed = false;                      ///< six columns without names: the last three may be normals or colours
  std::vector<std::string_view> names = {};  ///< of all columns, where they are known without a header
};

/// Of the current line, which is the first with content. Adds what there is to remark. Throws BadInput naming the line, and
/// WrongUsage when two columns turn out to be one.
TableLayout lay_out_table(const TableLines& lines, TableKind kind, const CloudRequest& request,
                          std::vector<std::string>& remarks);

/// Whether a column is requested by its name, which a header has to have.
bool is_by_name(const std::optional<std::vector<Column>>& columns);

}  // namespace rbpa::app
