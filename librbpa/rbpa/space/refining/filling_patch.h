// What:   the triangles that fill one hole, while they are refined.
// Law:    a function of the patch as it is given: of the order of its vertices and triangles.
// Source: Liepa, Filling holes in meshes (2003).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/mesh.h"
#include "rbpa/space/refining/fan_curvature.h"
#include "rbpa/surface.h"

namespace rbpa::space {

/// What is given of a patch. Its vertices, the rim, have numbers from 0.
struct FillingRim {
  std::vector<Vector> places;         ///< of the vertices; all different
  std::vector<double> scales;         ///< of each the mean length of its edges outside of the patch
  std::vector<FanCurvature> outside;  ///< of each, of the triangles there that are outside
  /// Of each twice the mean curvature of the two rings outside next to it; none where there is none whose triangles are all
  /// outside.
  std::vector<std::optional<double>> bend;
  std::vector<bool> is_inner;                               ///< of each, whether triangles are all around it
  Surface triangles;                                        ///< of vertices, glued; the least first, sorted
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< that join vertices outside of the patch, low < high
};

class FillingPatch {
 public:
  explicit FillingPatch(const FillingRim& rim);

  /// Adds vertices until triangles are about as large as the rim's edges, at most so many.
  void refine(std::size_t most, meshops::Steps& step);
  /// Moves the added vertices, so that the surface goes on over the rim without an edge and as curved as it is there, the curvature in
  /// between harmonic. Returns: false, and nothing is moved, where that is not determined. Throws: Cancelled.
  bool make_smooth(meshops::Steps& step);

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
  bool split_large(meshops::Steps& step);
  bool is_large(Mesh::FaceHandle f) const;
  void flip_all(meshops::Steps& step);
  std::optional<std::vector<double>> bends() const;
  std::optional<double> most_bend() const;
  bool bend_like(const std::vector<double>& bends, meshops::Steps& step, double& farthest);
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
