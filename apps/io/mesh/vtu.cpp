#include "io/mesh/vtu.h"

namespace rbpa::app {
namespace {

constexpr std::uint8_t vtk_vertex = 1, vtk_line = 3, vtk_triangle = 5, vtk_tetrahedron = 10;

/// Declares arrays in XML, each with its offset in the appended data, where the number of its bytes precedes them.
class Declarations {
 public:
  explicit Declarations(OutputFile& file) : file_(file) {}

  void declare(std::string_view type, const std::string& attributes, std::uint64_t bytes) {
    file_.write("<DataArray type=\"");
    file_.write(type);
    file_.write("\" " + attributes + " format=\"appended\" offset=\"");
    file_.write_number(offset_);
    file_.write("\"/>\n");
    offset_ += sizeof(std::uint64_t) + bytes;
  }
  void declare(std::string_view element, std::string_view shown, const std::vector<VtuArray>& arrays) {
    if (arrays.empty()) return;
    const std::string name(element);
    file_.write("<" + name + (shown.empty() ? "" : " ") + std::string(shown) + ">\n");
    for (const VtuArray& array : arrays) {
      const std::string components =
          array.components == 1 ? "" : " NumberOfComponents=\"" + std::to_string(array.components) + "\"";
      declare(array.type, "Name=\"" + array.name + "\"" + components, array.bytes);
    }
    file_.write("</" + name + ">\n");
  }

 private:
  OutputFile& file_;
  std::uint64_t offset_ = 0;
};

void write_size(OutputFile& file, std::uint64_t bytes) { file.write_binary(std::span<const std::uint64_t>(&bytes, 1)); }

template <typename T>
void write_repeated(OutputFile& file, T value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) file.write_binary(std::span<const T>(&value, 1));
}

/// Writes the offsets of the ends of `count` cells with `corners` corners each, among the corners of all cells.
void write_ends(OutputFile& file, std::uint64_t& end, std::uint64_t corners, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    end += corners;
    file.write_binary(std::span<const std::uint64_t>(&end, 1));
  }
}

void write_arrays(OutputFile& file, const std::vector<VtuArray>& arrays) {
  for (const VtuArray& array : arrays) {
    write_size(file, array.bytes);
    array.write(file);
  }
}

}  // namespace

void write_coordinates(OutputFile& file, std::span<const Point3> points) {
  for (const Point3& p : points) {
    const std::array<double, 3> coordinates = {p.x, p.y, p.z};
    file.write_binary(std::span<const double>(coordinates));
  }
}

void write_vtu(OutputFile& file, const VtuGrid& grid) {
  const std::uint64_t cells = grid.tetrahedra.size() + grid.triangles.size() + grid.edges.size() + grid.vertices.size();
  const std::uint64_t corners =
      4 * grid.tetrahedra.size() + 3 * grid.triangles.size() + 2 * grid.edges.size() + grid.vertices.size();
  const std::uint64_t of_positions = grid.points * 3 * sizeof(double), of_corners = corners * sizeof(std::uint32_t),
                      of_ends = cells * sizeof(std::uint64_t);
  file.write(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"");
  file.write_number(grid.points);
  file.write("\" NumberOfCells=\"");
  file.write_number(cells);
  file.write("\">\n<Points>\n");
  Declarations all(file);
  all.declare("Float64", "NumberOfComponents=\"3\"", of_positions);
  file.write("</Points>\n<Cells>\n");
  all.declare("UInt32", "Name=\"connectivity\"", of_corners);
  // The order matters to meshio, which looks arrays up by offsets that it changes: in another order it confuses the
  // last two arrays of a torus.
  all.declare("UInt8", "Name=\"types\"", cells);
  all.declare("UInt64", "Name=\"offsets\"", of_ends);
  file.write("</Cells>\n");
  all.declare("PointData", grid.shown_of_points, grid.of_points);
  all.declare("CellData", grid.shown_of_cells, grid.of_cells);
  file.write("</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");

  write_size(file, of_positions);
  grid.write_positions(file);
  write_size(file, of_corners);
  for (const auto& tetrahedron : grid.tetrahedra) file.write_binary(std::span<const std::uint32_t>(tetrahedron));
  for (const auto& triangle : grid.triangles) file.write_binary(std::span<const std::uint32_t>(triangle));
  for (const auto& edge : grid.edges) file.write_binary(std::span<const std::uint32_t>(edge));
  file.write_binary(grid.vertices);
  write_size(file, cells);
  write_repeated(file, vtk_tetrahedron, grid.tetrahedra.size());
  write_repeated(file, vtk_triangle, grid.triangles.size());
  write_repeated(file, vtk_line, grid.edges.size());
  write_repeated(file, vtk_vertex, grid.vertices.size());
  write_size(file, of_ends);
  std::uint64_t end = 0;
  write_ends(file, end, 4, grid.tetrahedra.size());
  write_ends(file, end, 3, grid.triangles.size());
  write_ends(file, end, 2, grid.edges.size());
  write_ends(file, end, 1, grid.vertices.size());
  write_arrays(file, grid.of_points);
  write_arrays(file, grid.of_cells);
  file.write("\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace rbpa::app
