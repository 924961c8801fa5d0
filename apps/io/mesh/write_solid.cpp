#include "io/mesh/write_solid.h"

#include <algorithm>

#include "io/bytes/number.h"
#include "io/mesh/polygon_files.h"
#include "io/mesh/vtu.h"

namespace rbpa::app {
namespace {

/// Writes a line of Medit's format: the values, and 0, the number of their part.
template <typename Values>
void write_medit_line(OutputFile& file, const Values& values) {
  char* at = file.room(values.size() * (number_room + 1) + 2);
  for (const auto value : values) {
    at = put_number(at, value);
    *at++ = ' ';
  }
  *at++ = '0';
  *at++ = '\n';
  file.written(at);
}

void write_medit(OutputFile& file, const SolidMesh& mesh) {
  file.write_all("MeshVersionFormatted 2\nDimension 3\nVertices\n", mesh.vertices.size(), "\n");
  for (const Point3& p : mesh.vertices) write_medit_line(file, position_of(p));
  file.write_all("Tetrahedra\n", mesh.tetrahedra.size(), "\n");
  for (const auto& tetrahedron : mesh.tetrahedra) {
    std::array<std::uint64_t, 4> corners{};
    std::transform(tetrahedron.begin(), tetrahedron.end(), corners.begin(),
                   [](std::uint32_t corner) { return std::uint64_t{corner} + 1; });
    write_medit_line(file, corners);
  }
  file.write("End\n");
}

void write_gmsh(OutputFile& file, const SolidMesh& mesh) {
  file.write_all("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n", mesh.vertices.size(), "\n");
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    file.write_all(i + 1, " ");
    write_position(file, "", position_of(mesh.vertices[i]));
  }
  file.write_all("$EndNodes\n$Elements\n", mesh.tetrahedra.size(), "\n");
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    file.write_all(t + 1, " 4 2 1 1");  // a tetrahedron, with two tags: its physical and its geometrical entity
    write_corners(file, mesh.tetrahedra[t], 1);
  }
  file.write("$EndElements\n");
}

}  // namespace

void write_solid(OutputFile& file, Format format, const SolidMesh& mesh) {
  if (format == Format::npy) return write_npy_rows(file, mesh.tetrahedra, mesh.index);
  if (format == Format::medit) return write_medit(file, mesh);
  if (format == Format::gmsh) return write_gmsh(file, mesh);
  write_vtu(file, {.positions = vtu_positions(mesh.vertices), .tetrahedra = mesh.tetrahedra});
}

}  // namespace rbpa::app
