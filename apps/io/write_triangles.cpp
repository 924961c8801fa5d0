#include "io/write_triangles.h"

#include <string>

#include "io/polygon_files.h"

namespace rbpa::app {
namespace {

/// The mesh in space, as the formats see it.
struct InSpace {
  const TriangleMesh& mesh;

  std::size_t points() const { return mesh.vertices.size(); }
  std::size_t faces() const { return mesh.triangles.size(); }
  std::array<double, 3> point(std::size_t i) const { return {mesh.vertices[i].x, mesh.vertices[i].y, 0}; }
  std::span<const std::uint32_t> face(std::size_t f) const { return mesh.triangles[f]; }
};

void write_npy(OutputFile& file, const TriangleMesh& mesh) {
  std::string header = "{'descr': '<u4', 'fortran_order': False, 'shape': (" +
                       std::to_string(mesh.triangles.size()) + ", 3), }";
  constexpr std::size_t before = 10, alignment = 64;  // bytes before the text; where NumPy wants the data
  header.append(alignment - (before + header.size() + 1) % alignment, ' ');
  header += '\n';
  file.write(std::string_view("\x93NUMPY\x01\x00", 8));
  const char length[2] = {static_cast<char>(header.size() & 0xFFU), static_cast<char>(header.size() >> 8U)};
  file.write({length, 2});
  file.write(header);
  static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));
  if (!mesh.triangles.empty())
    file.write_binary(std::span<const std::uint32_t>(mesh.triangles.front().data(), 3 * mesh.triangles.size()));
}

}  // namespace

void write_triangles(OutputFile& file, OutputFormat format, const TriangleMesh& mesh) {
  switch (format) {
    case OutputFormat::off: return write_off(file, InSpace{mesh});
    case OutputFormat::obj: return write_obj(file, InSpace{mesh});
    case OutputFormat::ply: return write_ply(file, InSpace{mesh});
    case OutputFormat::npy: return write_npy(file, mesh);
    case OutputFormat::svg:
    case OutputFormat::png: break;
  }
}

CompactMesh::CompactMesh(std::span<const Point> points, std::span<const Triangle> of_points)
    : triangles(of_points.begin(), of_points.end()) {
  std::vector<bool> used(points.size(), false);
  for (const Triangle& triangle : of_points)
    for (const std::uint32_t corner : triangle) used[corner] = true;
  std::vector<std::uint32_t> renumbered(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!used[i]) continue;
    renumbered[i] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(points[i]);
  }
  for (Triangle& triangle : triangles)
    for (std::uint32_t& corner : triangle) corner = renumbered[corner];
}

}  // namespace rbpa::app
