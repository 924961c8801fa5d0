// What: triangles in the plane, and edges and points beside them, as files.
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
#include "io/polygon/triangle_features.h"
#include "rbpa/base/point.h"

namespace rbpa::app {

using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::array<std::uint32_t, 2>;

/// A number of each feature.
struct FeatureNumbers {
  std::string name;
  std::span<const double> values;
};

/// What triangles are parts of: a number for each, and more numbers by that.
struct TriangleFeatures {
  std::string name = "feature";  ///< what they are called
  std::vector<std::uint32_t> of_triangle;
  std::vector<FeatureNumbers> numbers;
  std::span<const std::string> names = {};  ///< of each feature, where it has one
  bool names_are_numbers = false;
};

/// All as indices into vertices.
struct TriangleMesh {
  std::span<const Point> vertices;
  std::span<const Triangle> triangles;
  std::span<const Edge> edges = {};            ///< in no triangle
  std::span<const std::uint32_t> points = {};  ///< in neither
  const TriangleFeatures* features = nullptr;  ///< where there are neither edges nor points
  std::span<const std::uint16_t> levels = {};  ///< of each triangle, if it has one; likewise
  std::span<const double> z = {};              ///< of each vertex; none: 0 of all
  std::span<const std::uint32_t> index =
      {};  ///< of each vertex among the points of the input; none where that is its number

  std::array<double, 3> position(std::size_t i) const { return {vertices[i].x, vertices[i].y, z.empty() ? 0 : z[i]}; }
};

/// The mesh without the vertices that nothing uses; the others keep their order, and so do triangles, edges and points.
class CompactMesh {
 public:
  explicit CompactMesh(const TriangleMesh& mesh);
  TriangleMesh mesh() const { return {vertices_, triangles_, edges_, points_, features_, levels_, z_}; }

 private:
  std::vector<Point> vertices_;
  std::vector<double> z_;
  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> points_;
  const TriangleFeatures* features_;       // of the mesh that was compacted, as
  std::span<const std::uint16_t> levels_;  // these
};

/// OFF, PLY (binary little-endian, coordinates as double) or OBJ, or indices alone as an .npy array of uint32:
/// triangles with shape (n, 3), edges with shape (n, 2) or points with shape (n); or VTU (write_vtu.h). PLY has the feature of each triangle, where there are
/// features, as a property of faces of their name. OBJ, as lines f, l
/// and p, and VTU have all three; OFF and PLY leave edges and points out. Requires: not a picture format.
void write_triangles(OutputFile& file, Format format, const TriangleMesh& mesh);

/// The triangles as features of geographic information systems: with the number or name of each one's feature, with what features
/// have of numbers, and with levels. Keeps what the mesh keeps.
TriangleList list_of_triangles(const TriangleMesh& mesh, const std::optional<Crs>& crs, bool degrees);

/// Appended raw data, little-endian: cells are the triangles, then the edges, then the points. Levels as cell data `level`. Of features
/// the number, as cell data under their name, and what they have of numbers, as cell data under their own names; where a name comes
/// twice, with _2 and so on behind it.
void write_vtu(OutputFile& file, const TriangleMesh& mesh);

}  // namespace rbpa::app
