// What: writes triangles in the plane, together with the edges and points of a full complex.
// Law:  the bytes depend on the mesh alone; coordinates read back to the same doubles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "io/point_columns.h"
#include "io/polygon/write_shapes.h"
#include "rbpa/base/point.h"

namespace rbpa::app {

using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::array<std::uint32_t, 2>;

/// An attribute of features: its name, and a number for each feature.
struct FeatureNumbers {
  std::string name;
  std::span<const double> values;
};

/// The features of which triangles are parts, each with a number, attributes and perhaps a name.
struct TriangleFeatures {
  std::string name = "feature";  ///< name of the attribute with the number of the feature
  std::vector<std::uint32_t> of_triangle;
  std::vector<FeatureNumbers> numbers;
  std::span<const std::string> names = {};  ///< name of each feature; empty if features have no names
  bool names_are_numbers = false;
};

/// A mesh in the plane; triangles, edges and points are indices into the vertices.
struct TriangleMesh {
  std::span<const Point> vertices;
  std::span<const Triangle> triangles;
  std::span<const Edge> edges = {};            ///< edges in no triangle
  std::span<const std::uint32_t> points = {};  ///< points in no triangle and no edge
  const TriangleFeatures* features = nullptr;  ///< null if there are edges or points
  std::span<const std::uint16_t> levels = {};  ///< level of each triangle; empty if there are edges or points
  std::span<const double> z = {};              ///< height of each vertex; empty if all are 0
  std::span<const std::uint32_t> index = {};   ///< input index of each vertex; empty if vertex i has index i
  VertexFields fields = {};                    ///< written to PLY and VTU

  std::array<double, 3> position(std::size_t i) const { return {vertices[i].x, vertices[i].y, z.empty() ? 0 : z[i]}; }
};

/// A copy of a mesh without unused vertices. The other vertices, the triangles, edges and points keep their order.
/// Views features and levels of the original, and drops `index`.
class CompactMesh {
 public:
  explicit CompactMesh(const TriangleMesh& mesh);
  TriangleMesh mesh() const {
    return {vertices_, triangles_, edges_, points_, features_, levels_, z_, {}, {columns_, rows_}};
  }

 private:
  std::vector<Point> vertices_;
  std::vector<double> z_;
  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> points_;
  const TriangleFeatures* features_;       // views the original mesh
  std::span<const std::uint16_t> levels_;  // views the original mesh
  std::span<const PointColumn> columns_;   // views the original mesh
  std::vector<std::uint32_t> rows_;
};

/// Writes OFF, PLY (binary little-endian, coordinates as double), OBJ or VTU (write_vtu() below); or an .npy array of
/// uint32: triangles with shape (n, 3), edges with shape (n, 2) or points with shape (n). In PLY each face has the
/// number of its feature, if there are features, as a property called features->name, and each vertex has its fields
/// (ply_fields.h). OBJ, as lines f, l and p, and VTU have triangles, edges and points; OFF and PLY have triangles only.
/// Requires: not a picture format.
void write_triangles(OutputFile& file, Format format, const TriangleMesh& mesh);

/// Returns the triangles for geographic information systems: attributes of each are the number or name of its feature,
/// the numbers of that feature, and its level. Views the data that the mesh views.
TriangleTable table_of_triangles(const TriangleMesh& mesh, const std::optional<Crs>& crs, bool degrees);

/// Writes VTU with appended raw data, little-endian: cells are the triangles, then the edges, then the points. Cell
/// data are, if the mesh has features, the number of each cell's feature in an array with the name features->name, and
/// an array for each entry of features->numbers, with the name of the entry, or, if an array has that name, with a
/// suffix _2, _3 and so on; and, if the mesh has levels, an array `level`.
void write_vtu(OutputFile& file, const TriangleMesh& mesh);

}  // namespace rbpa::app
