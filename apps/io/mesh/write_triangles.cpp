#include "io/mesh/write_triangles.h"

#include <string>
#include <tuple>

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
      points_(mesh.points.begin(), mesh.points.end()) {
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
  std::string_view face_properties() const { return mesh.features == nullptr ? "" : "property uint feature\n"; }
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

/// `columns`: as npy_header() has them.
void write_npy(OutputFile& file, std::size_t rows, std::string_view columns, std::span<const std::uint32_t> values) {
  file.write(npy_header("<u4", rows, columns));
  if (!values.empty()) file.write_binary(values);
}

/// The indices of all rows one after another.
template <typename Rows>
std::span<const std::uint32_t> flat(const Rows& rows) {
  static_assert(sizeof(rows[0]) == sizeof(std::uint32_t) * std::tuple_size_v<typename Rows::value_type>);
  if (rows.empty()) return {};
  return {rows.front().data(), rows.size() * rows.front().size()};
}

}  // namespace

void write_triangles(OutputFile& file, Format format, const TriangleMesh& mesh) {
  switch (format) {
    case Format::off:
      return write_off(file, InSpace{mesh});
    case Format::obj:
      return write_obj_with_all(file, mesh);
    case Format::ply:
      return write_ply(file, InSpace{mesh});
    case Format::npy:
      return write_npy(file, mesh.triangles.size(), ", 3", flat(mesh.triangles));
    case Format::npy_edges:
      return write_npy(file, mesh.edges.size(), ", 2", flat(mesh.edges));
    case Format::npy_points:
      return write_npy(file, mesh.points.size(), ",", mesh.points);
    case Format::vtu:
      return write_vtu(file, mesh);
    default:
      break;
  }
}

}  // namespace rbpa::app
