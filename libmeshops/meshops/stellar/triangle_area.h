// What: the area of a triangle as a weight for triangulate_face().
#pragma once

#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <array>
#include <cmath>
#include <cstddef>

#include "meshops/core/connectivity.h"
#include "meshops/stellar/split_hooks.h"

namespace meshops {

/// Weight that returns the area of the triangle of three vertices, in the squared unit of the points. The points have
/// two or three coordinates; other meshes do not compile. Keeps a reference to the mesh.
template <HasPoints Mesh>
class TriangleArea {
 public:
  explicit TriangleArea(const Mesh& mesh) : mesh_(&mesh) {}
  explicit TriangleArea(const Mesh&&) = delete;  // the weight would outlive the mesh

  double operator()(Vertex a, Vertex b, Vertex c) const {
    const auto u = between(a, b), v = between(a, c);
    const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
    return std::hypot(x, y, z) / 2;
  }

 private:
  static constexpr std::size_t dimension = OpenMesh::vector_traits<typename Mesh::Point>::size_;
  static_assert(dimension == 2 || dimension == 3);

  std::array<double, 3> between(Vertex from, Vertex to) const {
    std::array<double, 3> along = {0, 0, 0};
    for (std::size_t i = 0; i < dimension; ++i)
      along[i] = static_cast<double>(mesh_->point(to)[i]) - static_cast<double>(mesh_->point(from)[i]);
    return along;
  }

  const Mesh* mesh_;
};

}  // namespace meshops
