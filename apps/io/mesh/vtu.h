// What: writes unstructured grids of VTK as XML with appended raw data, little-endian.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/output_file.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// An array with numbers for each point, or for each cell.
struct VtuArray {
  std::string_view type;  ///< of VTK: "Float64", "UInt32", "UInt8"
  std::string name;       ///< as XML
  std::size_t components = 1;
  std::uint64_t bytes = 0;
  std::function<void(OutputFile&)> write = {};  ///< writes exactly `bytes` bytes
};

/// A grid whose cells are the tetrahedra, then the triangles, the edges and the vertices, all as indices of points.
struct VtuGrid {
  std::uint64_t points = 0;
  std::function<void(OutputFile&)> write_positions = {};  ///< writes three doubles for each point
  std::span<const std::array<std::uint32_t, 4>> tetrahedra = {};
  std::span<const std::array<std::uint32_t, 3>> triangles = {};
  std::span<const std::array<std::uint32_t, 2>> edges = {};
  std::span<const std::uint32_t> vertices = {};
  std::vector<VtuArray> of_points = {}, of_cells = {};
  /// The arrays that programs show first, as XML attributes: `Scalars="feature"`.
  std::string shown_of_points = {}, shown_of_cells = {};
};

/// Writes three doubles for each point.
void write_coordinates(OutputFile& file, std::span<const Point3> points);

void write_vtu(OutputFile& file, const VtuGrid& grid);

}  // namespace rbpa::app
