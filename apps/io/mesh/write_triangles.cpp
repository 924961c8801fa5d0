#include "io/mesh/write_triangles.h"

#include <string>

#include "io/bytes/npy.h"
#include "io/mesh/polygon_files.h"

namespace rbpa::app {
namespace {

/// Calls visit(i) for every index; it may change them.
template <typename Visit>
void for_each_index(std::vector<Triangle>& triangles, std::vector<Edge>& edges, std::vector<std::uint32_t>& points,
                    const Visit& visit) {
  for (Triangle& triangle : triangles)
    for (std::uint32_t& i : triangle) visit(i);
  for (Edge& edge : edges)
    for (std::uint32_t& i : edge) visit(i);
  for (std::uint32_t& i : points) visit(i);
}

}  // namespace

CompactMesh::CompactMesh(const TriangleMesh& mesh)
    : triangles_(mesh.triangles.begin(), mesh.triangles.end()),
      edges_(mesh.edges.begin(), mesh.edges.end()),
      points_(mesh.points.begin(), mesh.points.end()),
      features_(mesh.features),
      levels_(mesh.levels) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for_each_index(triangles_, edges_, points_, [&](std::uint32_t i) { used[i] = true; });
  std::vector<std::uint32_t> renumbered(mesh.vertices.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    renumbered[i] = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back(mesh.vertices[i]);
  }
  for_each_index(triangles_, edges_, points_, [&](std::uint32_t& i) { i = renumbered[i]; });
}

namespace {

/// The mesh in space, as the formats see it.
struct InSpace {
  const TriangleMesh& mesh;

  std::size_t points() const { return mesh.vertices.size(); }
  std::size_t faces() const { return mesh.triangles.size(); }
  std::array<double, 3> point(std::size_t i) const { return {mesh.vertices[i].x, mesh.vertices[i].y, 0}; }
  std::span<const std::uint32_t> face(std::size_t f) const { return mesh.triangles[f]; }
  std::string face_properties() const {
    return mesh.features == nullptr ? "" : "property uint " + mesh.features->name + "\n";
  }
  void write_face_properties(OutputFile& file, std::size_t f) const {
    if (mesh.features != nullptr)
      file.write_binary(std::span<const std::uint32_t>(mesh.features->of_triangle).subspan(f, 1));
  }
};

void write_obj_with_all(OutputFile& file, const TriangleMesh& mesh) {
  write_obj(file, InSpace{mesh});
  for (const Edge& edge : mesh.edges) {
    file.write("l");
    write_corners(file, edge, 1);
  }
  for (const std::uint32_t& point : mesh.points) {
    file.write("p");
    write_corners(file, {&point, 1}, 1);
  }
}

}  // namespace

void write_triangles(OutputFile& file, Format format, const TriangleMesh& mesh) {
  switch (format) {
    case Format::obj:
      return write_obj_with_all(file, mesh);
    case Format::npy:
      return write_npy_rows(file, mesh.triangles);
    case Format::npy_edges:
      return write_npy_rows(file, mesh.edges);
    case Format::npy_points:
      file.write(npy_header("<u4", mesh.points.size(), ","));
      return file.write_binary(mesh.points);
    case Format::vtu:
      return write_vtu(file, mesh);
    default:
      return write_polygons(file, format, InSpace{mesh});
  }
}

}  // namespace rbpa::app
