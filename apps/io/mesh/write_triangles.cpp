#include "io/mesh/write_triangles.h"

#include <string>

#include "io/bytes/npy.h"
#include "io/mesh/ply_fields.h"
#include "io/mesh/polygon_files.h"

namespace rbpa::app {
namespace {

/// Calls visit(i) with a reference to every index i of a vertex.
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
      levels_(mesh.levels),
      columns_(mesh.fields.columns) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for_each_index(triangles_, edges_, points_, [&](std::uint32_t i) { used[i] = true; });
  std::vector<std::uint32_t> renumbered(mesh.vertices.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    renumbered[i] = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back(mesh.vertices[i]);
    if (!mesh.z.empty()) z_.push_back(mesh.z[i]);
    if (!columns_.empty()) rows_.push_back(static_cast<std::uint32_t>(mesh.fields.row(i)));
  }
  for_each_index(triangles_, edges_, points_, [&](std::uint32_t& i) { i = renumbered[i]; });
}

namespace {

/// A TriangleMesh as the `Mesh` of polygon_files.h; z is 0 if the mesh has no heights.
struct WithHeights {
  const TriangleMesh& mesh;
  PlyFields fields{mesh.fields};

  std::size_t points() const { return mesh.vertices.size(); }
  std::size_t faces() const { return mesh.triangles.size(); }
  std::array<double, 3> point(std::size_t i) const { return mesh.position(i); }
  std::span<const std::uint32_t> face(std::size_t f) const { return mesh.triangles[f]; }
  std::string comments() const { return fields.comments(); }
  std::string properties() const { return fields.lines(); }
  void write_properties(OutputFile& file, std::size_t i) const { fields.write(file, i); }
  std::string face_properties() const {
    return mesh.features == nullptr ? "" : "property uint " + mesh.features->name + "\n";
  }
  void write_face_properties(OutputFile& file, std::size_t f) const {
    if (mesh.features != nullptr) file.write_binary(mesh.features->of_triangle[f]);
  }
};

void write_obj_with_all(OutputFile& file, const TriangleMesh& mesh) {
  write_obj(file, WithHeights{.mesh = mesh});
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

TriangleTable table_of_triangles(const TriangleMesh& mesh, const std::optional<Crs>& crs, bool degrees) {
  TriangleTable table{.count = mesh.triangles.size(),
                      .corners =
                          [mesh](std::size_t t) {
                            std::array<Point3, 3> corners;
                            for (std::size_t k = 0; k < 3; ++k) {
                              const auto [x, y, z] = mesh.position(mesh.triangles[t][k]);
                              corners[k] = {x, y, z};
                            }
                            return corners;
                          },
                      .has_z = !mesh.z.empty(),
                      .attributes = {},
                      .points = mesh.vertices,
                      .crs = crs,
                      .degrees = degrees};
  if (!mesh.levels.empty())
    table.attributes.push_back(
        {.name = "level", .number = [levels = mesh.levels](std::size_t t) { return levels[t]; }});
  if (mesh.features == nullptr) return table;
  const TriangleFeatures& features = *mesh.features;
  TriangleAttribute& which = table.attributes.emplace_back();
  which.name = features.name;
  if (features.names.empty())
    which.number = [&features](std::size_t t) { return features.of_triangle[t]; };
  else if (features.names_are_numbers)
    which.number = [&features](std::size_t t) {
      return parse_whole_number(features.names[features.of_triangle[t]]).value;
    };
  else
    which.text = [&features](std::size_t t) { return features.names[features.of_triangle[t]]; };
  for (const FeatureNumbers& numbers : features.numbers) {
    if (!features.names.empty() && numbers.name == "name") continue;  // the feature's own name is there already
    table.attributes.push_back({.name = numbers.name, .number = [&features, values = numbers.values](std::size_t t) {
                                  return values[features.of_triangle[t]];
                                }});
  }
  return table;
}

void write_triangles(OutputFile& file, Format format, const TriangleMesh& mesh) {
  if (format == Format::obj) return write_obj_with_all(file, mesh);
  if (format == Format::npy) return write_npy_rows(file, mesh.triangles, mesh.index);
  if (format == Format::npy_edges) return write_npy_rows(file, mesh.edges, mesh.index);
  if (format == Format::vtu) return write_vtu(file, mesh);
  if (format != Format::npy_points) return write_polygons(file, format, WithHeights{.mesh = mesh});
  file.write(npy_header("<u4", mesh.points.size(), ","));
  file.write_binary(std::span<const std::uint32_t>(renumbered(mesh.points, mesh.index)));
}

}  // namespace rbpa::app
