// What: a mesh whose vertices are at points, any number of vertices at each point, with the attributes of the points.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "io/mesh/write_mesh.h"
#include "io/values_at.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// Owns the vertices and their attributes; views the triangles.
class VerticesOfPoints {
 public:
  /// `of_points` has the positions and attributes of the points; its triangles are not read. `point` has the point of
  /// each vertex. With `names_points`, mesh().points has the input index of the point of each vertex.
  VerticesOfPoints(const SpaceMesh& of_points, std::span<const std::array<std::uint32_t, 3>> triangles,
                   std::span<const std::uint32_t> point, bool names_points)
      : places_(values_at(of_points.vertices, point)),
        normals_(values_at(of_points.normals, point)),
        colors_(values_at(of_points.colors, point)),
        confidence_(values_at(of_points.confidence, point)),
        points_(names_points ? renumbered(point, of_points.index) : std::vector<std::uint32_t>()),
        columns_(of_points.fields.columns),
        rows_(columns_.empty() ? std::vector<std::uint32_t>() : renumbered(point, of_points.fields.rows)),
        triangles_(triangles),
        shift_(of_points.shift) {}

  /// Returns a view of this object and of the triangles.
  SpaceMesh mesh() const {
    return {.vertices = places_,
            .triangles = triangles_,
            .normals = normals_,
            .colors = colors_,
            .points = points_,
            .confidence = confidence_,
            .shift = shift_,
            .fields = {columns_, rows_}};
  }

 private:
  std::vector<Point3> places_, normals_;
  std::vector<std::array<std::uint8_t, 3>> colors_;
  std::vector<double> confidence_;
  std::vector<std::uint32_t> points_;
  std::span<const PointColumn> columns_;
  std::vector<std::uint32_t> rows_;
  std::span<const std::array<std::uint32_t, 3>> triangles_;
  std::optional<Shift> shift_;
};

}  // namespace rbpa::app
