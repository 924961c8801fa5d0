// What:   the triangles that fill one hole, while they are refined.
// Law:    a function of the patch as it is given: of the order of its vertices and triangles.
// Source: Liepa, Filling holes in meshes (2003).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "rbpa/mesh.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/surface.h"

namespace rbpa::space {

using Vector = Vector3<double>;

/// What is given of a patch. Its vertices, the rim, have numbers from 0.
struct FillingRim {
  std::vector<Vector> places;  ///< of the vertices; all different
  std::vector<double> scales;  ///< of each the mean length of its edges outside of the patch
  /// Of each the places of its neighbours outside.
  std::vector<std::vector<Vector>> outside;
  std::vector<bool> is_inner;                               ///< of each, whether triangles are all around it
  Surface triangles;                                        ///< of vertices, glued; the least first, sorted
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< that join vertices outside of the patch, low < high
};

class FillingPatch {
 public:
  explicit FillingPatch(const FillingRim& rim);

  /// Adds vertices until triangles are about as large as the rim's edges, at most so many.
  void refine(std::size_t most);
  /// Moves the added vertices, to where the surface with what is outside bends least. Returns: false, and nothing is moved,
  /// where that is not determined.
  bool make_smooth();

  std::size_t added() const { return between_.size(); }
  Vector place(std::size_t added) const;
  /// The vertices between which each was added. Those of the rim come first in numbers.
  const std::vector<std::array<std::uint32_t, 3>>& between() const { return between_; }
  std::vector<std::array<std::uint32_t, 3>> triangles() const;
  /// Whether a triangle has no area in double.
  bool is_degenerate() const;

 private:
  using Vertex = Mesh::VertexHandle;
  using Edge = Mesh::EdgeHandle;
  using Halfedge = Mesh::HalfedgeHandle;

  Vector at(Vertex v) const;
  std::uint32_t name(Vertex v) const { return names_[static_cast<std::size_t>(v.idx())]; }
  bool split_large();
  bool is_large(Mesh::FaceHandle f) const;
  void flip_all();
  bool is_better_flipped(Edge e) const;

  const FillingRim& rim_;
  Mesh mesh_;
  std::vector<std::uint32_t>
      names_;                   // by vertex: of the rim, which has several of one name where fans meet; of added ones
  std::vector<double> scales_;  // by name
  std::vector<std::array<std::uint32_t, 3>> between_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges_;  // of names: that there are, outside too
};

}  // namespace rbpa::space
