// What: writes unstructured grids of VTK as XML with appended raw data, little-endian.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/mesh/equal_positions.h"
#include "io/point_columns.h"

namespace rbpa::app {

/// An array with numbers for each point, or for each cell.
struct VtuArray {
  std::string_view type = {};  ///< VTK's name of the type: "Float64", "UInt32", "UInt16" or "UInt8"
  std::string name = {};       ///< escaped for XML
  std::size_t components = 1;
  std::uint64_t rows = 0, bytes = 0;
  std::function<void(OutputFile&)> write = {};  ///< writes exactly `bytes` bytes
};

/// Returns the array of value(row) for each of `rows`. Requires: `rows` view data that outlive the array. A value is a
/// number or an std::array of numbers: doubles, or unsigned integers of 1, 2 or 4 bytes.
template <typename Rows, typename Value = std::identity>
VtuArray vtu_array(std::string_view name, Rows rows, Value value = {}) {
  using Row = std::remove_cvref_t<decltype(value(*rows.begin()))>;
  std::size_t components = 1;
  if constexpr (requires { std::tuple_size<Row>::value; }) components = std::tuple_size_v<Row>;
  const std::size_t size = sizeof(Row) / components;
  return {.type = size == 8   ? "Float64"
                  : size == 4 ? "UInt32"
                  : size == 2 ? "UInt16"
                              : "UInt8",
          .name = std::string(name),
          .components = components,
          .rows = rows.size(),
          .bytes = rows.size() * sizeof(Row),
          .write = [rows, value](OutputFile& file) {
            for (const auto& row : rows) file.write_binary(value(row));
          }};
}

/// A grid whose cells are, in this order, tetrahedra, triangles, edges and vertices, all as indices of points.
struct VtuGrid {
  VtuArray positions;  ///< three doubles for each point; its name is not used
  std::span<const std::array<std::uint32_t, 4>> tetrahedra = {};
  std::span<const std::array<std::uint32_t, 3>> triangles = {};
  std::span<const std::array<std::uint32_t, 2>> edges = {};
  std::span<const std::uint32_t> vertices = {};
  std::vector<VtuArray> of_points = {}, of_cells = {};
  std::vector<std::string> comments = {};  ///< lines before the arrays
  /// XML attributes that name the arrays which programs show first: `Scalars="feature"`.
  std::string shown_of_points = {}, shown_of_cells = {};
};

/// Returns VtuGrid::positions for `points`, which must outlive the array.
inline VtuArray vtu_positions(std::span<const Point3> points) { return vtu_array("", points, position_of); }

/// Appends the fields of the vertices to grid.of_points, with distinct names. Appends to grid.comments the text for
/// each number of a column of texts. Requires: grid.positions is set, and `fields` views data that outlive the grid.
void add_fields(const VertexFields& fields, VtuGrid& grid);

void write_vtu(OutputFile& file, const VtuGrid& grid);

}  // namespace rbpa::app
