#include "io/mesh/write_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/mesh/fan_triangles.h"
#include "io/mesh/ply_fields.h"
#include "io/mesh/polygon_files.h"
#include "io/mesh/vtu.h"
#include "io/number.h"

namespace rbpa::app {
namespace {

struct SoupPolygons {
  std::span<const std::array<double, 3>> positions;
  const meshops::PolygonSoup& soup;

  std::size_t points() const { return positions.size(); }
  std::size_t faces() const { return soup.faces(); }
  const std::array<double, 3>& point(std::size_t i) const { return positions[i]; }
  std::span<const std::uint32_t> face(std::size_t f) const { return soup.face(f); }
};

/// A SpaceMesh as the `Mesh` of polygon_files.h.
struct SurfacePolygons {
  const SpaceMesh& mesh;
  PlyFields fields{mesh.fields};

  std::size_t points() const { return mesh.vertices.size(); }
  std::size_t faces() const { return mesh.triangles.size(); }
  std::string comments() const { return fields.comments(); }
  Position point(std::size_t i) const { return position_of(mesh.vertices[i]); }
  std::span<const std::uint32_t> face(std::size_t f) const { return mesh.triangles[f]; }

  std::string properties() const {
    std::string lines;
    if (!mesh.normals.empty()) lines += "property double nx\nproperty double ny\nproperty double nz\n";
    if (!mesh.colors.empty()) lines += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    if (!mesh.points.empty()) lines += "property uint point\n";
    if (!mesh.confidence.empty()) lines += "property double confidence\n";
    return lines + fields.lines();
  }
  void write_properties(OutputFile& file, std::size_t i) const {
    if (!mesh.normals.empty()) file.write_binary(position_of(mesh.normals[i]));
    if (!mesh.colors.empty()) file.write_binary(mesh.colors[i]);
    if (!mesh.points.empty()) file.write_binary(mesh.points[i]);
    if (!mesh.confidence.empty()) file.write_binary(mesh.confidence[i]);
    fields.write(file, i);
  }
};

std::array<float, 3> unit_normal(const Point3& a, const Point3& b, const Point3& c) {
  const double u[] = {b.x - a.x, b.y - a.y, b.z - a.z}, v[] = {c.x - a.x, c.y - a.y, c.z - a.z};
  const double n[] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  // Return zeros, for which readers compute the normal from the corners.
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length), static_cast<float>(n[2] / length)};
}

/// Returns the first 80 bytes of the file, with the shift. They must not begin with "solid" as an ASCII file does.
std::string stl_header(const Position& shift) {
  std::string header = "triangles in space, binary STL";
  if (shift != Position{})  // at most 80 characters
    header = "shift " + text_of(shift);
  header.resize(80, ' ');
  return header;
}

void write_stl(OutputFile& file, const SpaceMesh& mesh) {
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    bad_input(file.name(), counted(mesh.triangles.size(), "triangle"),
              "fewer than 2^32 in an STL file (.ply has no limit)");
  const SinglePositions positions = kept_positions(file, Format::stl, mesh);
  file.write(stl_header(positions.shift));
  file.write_binary(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    const Point3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]], &c = mesh.vertices[triangle[2]];
    file.write_binary(unit_normal(a, b, c));
    for (const std::uint32_t corner : triangle) file.write_binary(positions.at[corner]);
    file.write({"\0\0", 2});
  }
}

}  // namespace

TriangulatedFaces::TriangulatedFaces(std::span<const std::array<double, 3>> positions,
                                     const meshops::PolygonSoup& soup) {
  for (const auto& p : positions) vertices.push_back({p[0], p[1], p[2]});
  for (std::size_t f = 0; f < soup.faces(); ++f)
    for_each_fan_triangle(soup.face(f), positions, [&](const auto& triangle) { triangles.push_back(triangle); });
}

SinglePositions kept_positions(const OutputFile& file, Format format, const SpaceMesh& mesh) {
  SinglePositions positions = single_positions(format, mesh.vertices, mesh.triangles, mesh.shift, file.name());
  const std::string why = why_not_kept(positions, format, mesh.vertices, mesh.triangles, file.name());
  if (!why.empty()) throw Failure(why + "; nothing is written");
  return positions;
}

void write_mesh(OutputFile& file, Format format, std::span<const std::array<double, 3>> positions,
                const meshops::PolygonSoup& soup, const std::optional<Shift>& shift) {
  if (format != Format::stl) return write_polygons(file, format, SoupPolygons{positions, soup});
  const TriangulatedFaces faces(positions, soup);
  write_stl(file, {.vertices = faces.vertices, .triangles = faces.triangles, .shift = shift});
}

void write_surface(OutputFile& file, Format format, const SpaceMesh& mesh) {
  if (format == Format::stl) return write_stl(file, mesh);
  if (format == Format::npy) return write_npy_rows(file, mesh.triangles, mesh.index);
  if (format == Format::vtu) return write_vtu(file, mesh);
  if (format == Format::glb) return write_glb(file, mesh);
  write_polygons(file, format, SurfacePolygons{.mesh = mesh});
}

namespace {

void write_obj_lines(OutputFile& file, std::span<const std::array<double, 3>> positions,
                     std::span<const Polyline> loops, std::span<const std::string_view> groups) {
  for (const std::array<double, 3>& p : positions) write_obj_vertex(file, p);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!groups.empty() && (i == 0 || groups[i] != groups[i - 1])) file.write_all("g ", groups[i], "\n");
    Polyline loop = loops[i];
    loop.push_back(loop.front());
    file.write("l");
    write_corners(file, loop, 1);
  }
}

void write_json_lines(OutputFile& file, std::span<const std::array<double, 3>> positions,
                      std::span<const Polyline> loops, std::span<const std::string_view> groups) {
  using Json = nlohmann::ordered_json;
  file.write("[");
  std::string_view before = "";
  for (std::size_t i = 0; i < loops.size(); ++i) {
    stop_if_interrupted();
    Json points = Json::array();
    for (const std::uint32_t v : loops[i]) points.push_back(positions[v]);
    Json line;
    if (!groups.empty()) line["kind"] = groups[i];
    line["vertices"] = loops[i];
    line["positions"] = std::move(points);
    file.write_all(std::exchange(before, ","), line.dump());
  }
  file.write("]\n");
}

}  // namespace

void write_polylines(OutputFile& file, Format format, std::span<const std::array<double, 3>> positions,
                     std::span<const Polyline> loops, std::span<const std::string_view> groups) {
  format == Format::obj ? write_obj_lines(file, positions, loops, groups)
                        : write_json_lines(file, positions, loops, groups);
}

namespace {

/// Writes a line of Medit's format: the values, and 0, the number of the part to which they belong.
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
  VtuGrid grid{.positions = vtu_positions(mesh.vertices), .tetrahedra = mesh.tetrahedra};
  add_fields(mesh.fields, grid);
  write_vtu(file, grid);
}

}  // namespace rbpa::app
