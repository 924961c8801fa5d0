#include "io/write_triangles.h"

#include <string>
#include <tuple>

#include "io/npy_header.h"
#include "io/polygon_files.h"
#include "io/write_vtu.h"

namespace rbpa::app {
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

void write_triangles(OutputFile& file, OutputFormat format, const TriangleMesh& mesh) {
  switch (format) {
    case OutputFormat::off:
      return write_off(file, InSpace{mesh});
    case OutputFormat::obj:
      return write_obj_with_all(file, mesh);
    case OutputFormat::ply:
      return write_ply(file, InSpace{mesh});
    case OutputFormat::npy:
      return write_npy(file, mesh.triangles.size(), ", 3", flat(mesh.triangles));
    case OutputFormat::npy_edges:
      return write_npy(file, mesh.edges.size(), ", 2", flat(mesh.edges));
    case OutputFormat::npy_points:
      return write_npy(file, mesh.points.size(), ",", mesh.points);
    case OutputFormat::vtu:
      return write_vtu(file, mesh);
    case OutputFormat::svg:
    case OutputFormat::png:
      break;
  }
}

}  // namespace rbpa::app
