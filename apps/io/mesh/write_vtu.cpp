#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/mesh/vtu.h"
#include "io/mesh/write_mesh.h"
#include "io/mesh/write_triangles.h"
#include "io/text/markup.h"

namespace rbpa::app {
namespace {

/// Returns the numbers of features as arrays with distinct names.
std::vector<VtuArray> arrays_of(const TriangleFeatures& features) {
  const std::span<const std::uint32_t> of_triangle = features.of_triangle;
  std::vector<VtuArray> arrays = {{.type = "UInt32",
                                   .name = features.name,
                                   .bytes = of_triangle.size_bytes(),
                                   .write = [of_triangle](OutputFile& file) { file.write_binary(of_triangle); }}};
  for (const FeatureNumbers& numbers : features.numbers) {
    const std::string name = markup_escaped(numbers.name);
    std::string unique = name;
    const auto is_taken = [&](const VtuArray& array) { return array.name == unique; };
    for (int i = 2; std::any_of(arrays.begin(), arrays.end(), is_taken); ++i) unique = name + "_" + std::to_string(i);
    arrays.push_back({.type = "Float64",
                      .name = unique,
                      .bytes = of_triangle.size() * sizeof(double),
                      .write = [of_triangle, values = numbers.values](OutputFile& file) {
                        for (const std::uint32_t feature : of_triangle) file.write_binary(values.subspan(feature, 1));
                      }});
  }
  return arrays;
}

}  // namespace

void write_vtu(OutputFile& file, const TriangleMesh& mesh) {
  VtuGrid grid{.points = mesh.vertices.size(),
               .write_positions =
                   [&](OutputFile& out) {
                     for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
                       const std::array<double, 3> position = mesh.position(i);
                       out.write_binary(std::span<const double>(position));
                     }
                   },
               .triangles = mesh.triangles,
               .edges = mesh.edges,
               .vertices = mesh.points};
  if (mesh.features != nullptr) {
    grid.of_cells = arrays_of(*mesh.features);
    grid.shown_of_cells = "Scalars=\"" + mesh.features->name + "\"";
  }
  if (!mesh.levels.empty()) {
    grid.of_cells.push_back(
        {.type = "UInt16", .name = "level", .bytes = mesh.levels.size_bytes(), .write = [&](OutputFile& out) {
           out.write_binary(mesh.levels);
         }});
    grid.shown_of_cells = "Scalars=\"level\"";
  }
  write_vtu(file, grid);
}

void write_vtu(OutputFile& file, const SpaceMesh& mesh) {
  VtuGrid grid{.points = mesh.vertices.size(),
               .write_positions = [&](OutputFile& out) { write_coordinates(out, mesh.vertices); },
               .triangles = mesh.triangles};
  const auto add = [&](std::string_view type, const std::string& name, std::size_t components, const auto& values,
                       const auto& write) {
    if (!values.empty())
      grid.of_points.push_back({.type = type,
                                .name = name,
                                .components = components,
                                .bytes = values.size_bytes(),
                                .write = [values, write](OutputFile& out) { write(out, values); }});
  };
  const auto write_numbers = [](OutputFile& out, const auto& values) { out.write_binary(values); };
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  if (!mesh.normals.empty()) grid.shown_of_points = "Normals=\"Normals\"";
  add("Float64", "Normals", 3, mesh.normals, write_coordinates);
  add("UInt8", "RGB", 3, mesh.colors, [](OutputFile& out, const auto& colors) {
    for (const auto& color : colors) out.write_binary(std::span<const std::uint8_t>(color));
  });
  add("UInt32", "point", 1, mesh.points, write_numbers);
  add("Float64", "confidence", 1, mesh.confidence, write_numbers);
  write_vtu(file, grid);
}

}  // namespace rbpa::app
