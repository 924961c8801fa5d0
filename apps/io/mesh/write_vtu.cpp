#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh/vtu.h"
#include "io/mesh/write_mesh.h"
#include "io/mesh/write_triangles.h"
#include "io/text/markup.h"

namespace rbpa::app {
namespace {

/// Returns the attributes of features, as arrays of a number for each triangle, with distinct names.
std::vector<VtuArray> arrays_of(const TriangleFeatures& features) {
  const std::span<const std::uint32_t> of_triangle = features.of_triangle;
  std::vector<VtuArray> arrays = {vtu_array(features.name, of_triangle)};
  for (const FeatureNumbers& numbers : features.numbers) {
    const std::string unique = untaken(markup_escaped(numbers.name), [&](const std::string& name) {
      return std::any_of(arrays.begin(), arrays.end(), [&](const VtuArray& array) { return array.name == name; });
    });
    arrays.push_back(
        vtu_array(unique, of_triangle, [values = numbers.values](std::uint32_t feature) { return values[feature]; }));
  }
  return arrays;
}

}  // namespace

void write_vtu(OutputFile& file, const TriangleMesh& mesh) {
  const auto position_of_vertex = [&](const Point& p) {
    return mesh.position(static_cast<std::size_t>(&p - mesh.vertices.data()));
  };
  VtuGrid grid{.positions = vtu_array("", mesh.vertices, position_of_vertex),
               .triangles = mesh.triangles,
               .edges = mesh.edges,
               .vertices = mesh.points};
  if (mesh.features != nullptr) {
    grid.of_cells = arrays_of(*mesh.features);
    grid.shown_of_cells = "Scalars=\"" + mesh.features->name + "\"";
  }
  if (!mesh.levels.empty()) {
    grid.of_cells.push_back(vtu_array("level", mesh.levels));
    grid.shown_of_cells = "Scalars=\"level\"";
  }
  add_fields(mesh.fields, grid);
  write_vtu(file, grid);
}

void write_vtu(OutputFile& file, const SpaceMesh& mesh) {
  VtuGrid grid{.positions = vtu_positions(mesh.vertices), .triangles = mesh.triangles};
  const auto add = [&](VtuArray array) {
    if (array.rows > 0) grid.of_points.push_back(std::move(array));
  };
  if (!mesh.normals.empty()) grid.shown_of_points = "Normals=\"Normals\"";
  add(vtu_array("Normals", mesh.normals, position_of));
  add(vtu_array("RGB", mesh.colors));
  add(vtu_array("point", mesh.points));
  add(vtu_array("confidence", mesh.confidence));
  add_fields(mesh.fields, grid);
  write_vtu(file, grid);
}

}  // namespace rbpa::app
