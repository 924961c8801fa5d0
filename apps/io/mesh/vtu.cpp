#include "io/mesh/vtu.h"

#include <algorithm>

#include "io/text/markup.h"

namespace rbpa::app {
namespace {

constexpr std::uint8_t vtk_vertex = 1, vtk_line = 3, vtk_triangle = 5, vtk_tetrahedron = 10;

/// Declares arrays in XML, each with its offset in the appended data, where the number of its bytes precedes them.
class Declarations {
 public:
  explicit Declarations(OutputFile& file) : file_(file) {}

  void declare(std::string_view type, const std::string& attributes, std::uint64_t bytes) {
    file_.write_all("<DataArray type=\"", type, "\" ", attributes, " format=\"appended\" offset=\"", offset_, "\"/>\n");
    offset_ += sizeof(std::uint64_t) + bytes;
  }
  void declare(std::string_view element, std::string_view shown, const std::vector<VtuArray>& arrays) {
    if (arrays.empty()) return;
    file_.write_all("<", element, shown.empty() ? "" : " ", shown, ">\n");
    for (const VtuArray& array : arrays) {
      const std::string components =
          array.components == 1 ? "" : " NumberOfComponents=\"" + std::to_string(array.components) + "\"";
      declare(array.type, "Name=\"" + array.name + "\"" + components, array.bytes);
    }
    file_.write_all("</", element, ">\n");
  }

 private:
  OutputFile& file_;
  std::uint64_t offset_ = 0;
};

/// Cells of one kind.
struct Cells {
  std::uint8_t type;
  std::uint64_t corners;  ///< number of corners of a cell
  std::uint64_t count;
};

void write_array(OutputFile& file, const VtuArray& array) {
  file.write_binary(array.bytes);
  array.write(file);
}

std::string_view vtk_name(Scalar type) {
  constexpr std::string_view names[] = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                        "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  return names[static_cast<std::size_t>(type)];
}

}  // namespace

void add_fields(const VertexFields& fields, VtuGrid& grid) {
  const std::size_t vertices = grid.positions.rows;
  for (const PointColumn& column : fields.columns) {
    const std::string name = untaken(markup_escaped(column.name), [&](const std::string& taken) {
      return std::any_of(grid.of_points.begin(), grid.of_points.end(),
                         [&](const VtuArray& array) { return array.name == taken; });
    });
    grid.of_points.push_back({.type = vtk_name(column.type),
                              .name = name,
                              .rows = vertices,
                              .bytes = vertices * size_of(column.type),
                              .write = [&column, fields, vertices](OutputFile& file) {
                                with_type(column.type, [&](auto value) {
                                  for (std::size_t i = 0; i < vertices; ++i)
                                    file.write_binary(column.value<decltype(value)>(fields.row(i)));
                                });
                              }});
    if (!column.is_text) continue;
    std::string comment = markup_escaped(column.name + ": " + legend_of(column));
    for (std::size_t at = 0; (at = comment.find("--", at)) != std::string::npos;) comment.insert(at + 1, 1, ' ');
    grid.comments.push_back(comment);
  }
}

void write_vtu(OutputFile& file, const VtuGrid& grid) {
  const Cells kinds[] = {{vtk_tetrahedron, 4, grid.tetrahedra.size()},
                         {vtk_triangle, 3, grid.triangles.size()},
                         {vtk_line, 2, grid.edges.size()},
                         {vtk_vertex, 1, grid.vertices.size()}};
  std::uint64_t cells = 0, corners = 0;
  for (const Cells& kind : kinds) cells += kind.count, corners += kind.count * kind.corners;
  const std::uint64_t of_corners = corners * sizeof(std::uint32_t), of_ends = cells * sizeof(std::uint64_t);
  file.write_all(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n");
  for (const std::string& comment : grid.comments) file.write_all("<!-- ", comment, " -->\n");
  file.write_all("<UnstructuredGrid>\n<Piece NumberOfPoints=\"", grid.positions.rows, "\" NumberOfCells=\"", cells,
                 "\">\n<Points>\n");
  Declarations all(file);
  all.declare("Float64", "NumberOfComponents=\"3\"", grid.positions.bytes);
  file.write("</Points>\n<Cells>\n");
  all.declare("UInt32", "Name=\"connectivity\"", of_corners);
  // Keep this order: meshio looks arrays up by offsets that it changes, and in another order confuses the last two
  // arrays of a torus.
  all.declare("UInt8", "Name=\"types\"", cells);
  all.declare("UInt64", "Name=\"offsets\"", of_ends);
  file.write("</Cells>\n");
  all.declare("PointData", grid.shown_of_points, grid.of_points);
  all.declare("CellData", grid.shown_of_cells, grid.of_cells);
  file.write("</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");

  write_array(file, grid.positions);
  file.write_binary(of_corners);
  for (const auto& tetrahedron : grid.tetrahedra) file.write_binary(tetrahedron);
  for (const auto& triangle : grid.triangles) file.write_binary(triangle);
  for (const auto& edge : grid.edges) file.write_binary(edge);
  file.write_binary(grid.vertices);
  file.write_binary(cells);
  for (const Cells& kind : kinds)
    for (std::uint64_t i = 0; i < kind.count; ++i) file.write_binary(kind.type);
  file.write_binary(of_ends);
  std::uint64_t end = 0;  // end of a cell among the corners of all cells
  for (const Cells& kind : kinds)
    for (std::uint64_t i = 0; i < kind.count; ++i) file.write_binary(end += kind.corners);
  for (const std::vector<VtuArray>* arrays : {&grid.of_points, &grid.of_cells})
    for (const VtuArray& array : *arrays) write_array(file, array);
  file.write("\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace rbpa::app
