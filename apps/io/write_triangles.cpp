#include "io/write_triangles.h"

#include <string>

namespace rbpa::app {
namespace {

void write_count(OutputFile& file, std::size_t count) { file.write_number(static_cast<std::uint64_t>(count)); }

void write_xy(OutputFile& file, const Point& p) {
  file.write_number(p.x);
  file.write(" ");
  file.write_number(p.y);
  file.write(" 0\n");
}

void write_corners(OutputFile& file, const Triangle& triangle, std::uint32_t first_index) {
  for (const std::uint32_t corner : triangle) {
    file.write(" ");
    file.write_number(std::uint64_t{corner} + first_index);
  }
  file.write("\n");
}

void write_off(OutputFile& file, const TriangleMesh& mesh) {
  file.write("OFF\n");
  write_count(file, mesh.vertices.size());
  file.write(" ");
  write_count(file, mesh.triangles.size());
  file.write(" 0\n");
  for (const Point& p : mesh.vertices) write_xy(file, p);
  for (const Triangle& triangle : mesh.triangles) {
    file.write("3");
    write_corners(file, triangle, 0);
  }
}

void write_obj(OutputFile& file, const TriangleMesh& mesh) {
  for (const Point& p : mesh.vertices) {
    file.write("v ");
    write_xy(file, p);
  }
  for (const Triangle& triangle : mesh.triangles) {
    file.write("f");
    write_corners(file, triangle, 1);
  }
}

void write_ply(OutputFile& file, const TriangleMesh& mesh) {
  file.write("ply\nformat binary_little_endian 1.0\nelement vertex ");
  write_count(file, mesh.vertices.size());
  file.write("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
  write_count(file, mesh.triangles.size());
  file.write("\nproperty list uchar int vertex_indices\nend_header\n");
  for (const Point& p : mesh.vertices) {
    file.write_binary(p.x);
    file.write_binary(p.y);
    file.write_binary(0.0);
  }
  for (const Triangle& triangle : mesh.triangles) {
    file.write("\x03");
    for (const std::uint32_t corner : triangle) file.write_binary(corner);
  }
}

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
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) file.write_binary(corner);
}

}  // namespace

void write_triangles(OutputFile& file, OutputFormat format, const TriangleMesh& mesh) {
  switch (format) {
    case OutputFormat::off: return write_off(file, mesh);
    case OutputFormat::obj: return write_obj(file, mesh);
    case OutputFormat::ply: return write_ply(file, mesh);
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
