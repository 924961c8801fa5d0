// What: triangles in the plane as files have them, and edges and points beside them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

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
  std::vector<std::uint32_t> of_triangle;
  std::vector<FeatureNumbers> numbers;
};

/// All as indices into vertices.
struct TriangleMesh {
  std::span<const Point> vertices;
  std::span<const Triangle> triangles;
  std::span<const Edge> edges = {};            ///< in no triangle
  std::span<const std::uint32_t> points = {};  ///< in neither
  const TriangleFeatures* features = nullptr;  ///< where there are neither edges nor points
};

/// The mesh without the vertices that nothing uses; the others keep their order, and so do triangles, edges and points.
class CompactMesh {
 public:
  explicit CompactMesh(const TriangleMesh& mesh);
  TriangleMesh mesh() const { return {vertices_, triangles_, edges_, points_}; }

 private:
  std::vector<Point> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> points_;
};

}  // namespace rbpa::app
