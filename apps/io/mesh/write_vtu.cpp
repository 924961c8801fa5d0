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
  if (!mesh.normals.empty()) {
    grid.shown_of_points = "Normals=\"Normals\"";
    grid.of_points.push_back({.type = "Float64",
                              .name = "Normals",
                              .components = 3,
                              .bytes = mesh.normals.size() * 3 * sizeof(double),
                              .write = [&](OutputFile& out) { write_coordinates(out, mesh.normals); }});
  }
  if (!mesh.colors.empty())
    grid.of_points.push_back({.type = "UInt8",
                              .name = "RGB",
                              .components = 3,
                              .bytes = mesh.colors.size_bytes(),
                              .write = [&](OutputFile& out) {
                                for (const auto& color : mesh.colors)
                                  out.write_binary(std::span<const std::uint8_t>(color));
                              }});
  if (!mesh.points.empty())
    grid.of_points.push_back(
        {.type = "UInt32", .name = "point", .bytes = mesh.points.size_bytes(), .write = [&](OutputFile& out) {
           out.write_binary(mesh.points);
         }});
  if (!mesh.confidence.empty())
    grid.of_points.push_back(
        {.type = "Float64", .name = "confidence", .bytes = mesh.confidence.size_bytes(), .write = [&](OutputFile& out) {
           out.write_binary(mesh.confidence);
         }});
  write_vtu(file, grid);
}

}  // namespace rbpa::app
