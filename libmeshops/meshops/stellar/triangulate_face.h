// What:   triangulates a polygonal face along diagonals with the least total weight.
// Law:    a face of k sides is cut by k − 3 calls of insert_diagonal(): remove_diagonal() of the returned diagonals,
//         from the last to the first, restores every live record of the mesh.
// Cost:   O(k³) weights, each with a few + and <, and O(k²) memory; suited to holes of up to some hundred edges.
// Source: Klincsek, Minimal triangulations of polygonal domains (1980); Barequet and Sharir, Filling gaps in the
//         boundary of a polyhedron (1995).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"
#include "meshops/core/delta.h"
#include "meshops/stellar/keep.h"
#include "meshops/stellar/split_hooks.h"
#include "meshops/stellar/triangle_area.h"

namespace meshops {

struct TriangulateFaceEffect {
  std::vector<Halfedge> diagonals;  ///< halfedges of the new edges, each with its new face on the left
  std::vector<Face> faces;          ///< the new faces, in the order of `diagonals`
  Delta delta() const { return {.edges = static_cast<int>(diagonals.size()), .faces = static_cast<int>(faces.size())}; }
};

/// Weight of triangles: weight(a, b, c), for three corners in their order around the face, returns a value of any type
/// that has + and <, and not NaN. If + returns the greater of its operands, the worst triangle becomes as good as
/// possible. The weight of a triangle must not depend on its neighbors, as angles between triangles do (Liepa 2003):
/// otherwise parts of least weight need not form a whole of least weight, and dynamic programming does not find the
/// least whole.
template <typename Weight>
concept TriangleWeight = requires(Weight& weight, Vertex v) {
  { weight(v, v, v) + weight(v, v, v) } -> std::convertible_to<std::remove_cvref_t<decltype(weight(v, v, v))>>;
  { weight(v, v, v) < weight(v, v, v) } -> std::convertible_to<bool>;
};

namespace detail {

/// Corners of a face, from the start of mesh.halfedge_handle(face) on, and the diagonals that are allowed between them.
class MESHOPS_API Polygon {
 public:
  Polygon(const Connectivity& mesh, Face face, Keep keep);

  /// Returns the number of corners; 0 if the face does not exist or, with Keep::simplicial, passes a vertex twice.
  std::size_t size() const { return sides_.size(); }
  /// Returns why the face has no triangulation. The value is meaningful only if the face has none.
  const Blocker& reason() const { return reason_; }
  Vertex corner(std::size_t i) const { return corners_[i]; }
  /// Returns whether corners i < j are neighbors along the face or may be joined by a diagonal.
  bool may_join(std::size_t i, std::size_t j) const {
    return j == i + 1 || (i == 0 && j + 1 == size()) || allowed_[i * size() + j];
  }
  /// Cuts the face along its new diagonals. Corners i and j form a triangle with corner apex[i · size() + j].
  TriangulateFaceEffect cut(Connectivity& mesh, const std::vector<std::uint32_t>& apex) const;

 private:
  std::vector<Halfedge> sides_;
  std::vector<Vertex> corners_;
  std::vector<bool> allowed_;
  Blocker reason_;
};

/// Returns a table of apexes. Entry i · size + j belongs to the part of the polygon from corner i to corner j > i: it
/// is the apex of the triangle at i and j in the triangulation of the part with the least weight, and the least apex
/// among equal weights. Returns nothing if the whole polygon has no triangulation.
template <typename Weight>
std::optional<std::vector<std::uint32_t>> least_triangulation(const Polygon& polygon, Weight& weight) {
  using Sum = std::remove_cvref_t<decltype(weight(Vertex(), Vertex(), Vertex()))>;
  const std::size_t k = polygon.size();
  if (k == 0) return std::nullopt;
  std::vector<std::optional<Sum>> least(k * k);  // least weights of parts of three or more corners
  std::vector<std::uint32_t> apex(k * k, 0);
  for (std::size_t length = 2; length < k; ++length)
    for (std::size_t i = 0, j = length; j < k; ++i, ++j) {
      if (!polygon.may_join(i, j)) continue;
      std::optional<Sum>& best = least[i * k + j];
      for (std::size_t m = i + 1; m < j; ++m) {
        const auto& before = least[i * k + m];
        const auto& after = least[m * k + j];
        if ((m > i + 1 && !before) || (m + 1 < j && !after)) continue;
        Sum sum = weight(polygon.corner(i), polygon.corner(m), polygon.corner(j));
        if (before) sum = sum + *before;
        if (after) sum = sum + *after;
        if (best && !(sum < *best)) continue;
        best = sum;
        apex[i * k + j] = static_cast<std::uint32_t>(m);
      }
    }
  if (!least[k - 1]) return std::nullopt;
  return apex;
}

}  // namespace detail

/// Returns why the face cannot be triangulated, or nothing when it can. The reasons: the face does not exist or is
/// deleted; every triangulation has an edge with one vertex at both ends; or, with Keep::simplicial, every
/// triangulation has an edge between vertices that an edge joins already, or the face passes a vertex twice.
/// Cost: O(k³) time and O(k²) memory for k sides; with Keep::simplicial, also the degrees of the corners.
MESHOPS_API std::optional<Blocker> triangulate_face_blocker(const Connectivity& mesh, Face face,
                                                            Keep keep = Keep::simplicial);

/// Triangulates a face with the least total weight. Among equal triangulations, the function chooses the one whose
/// triangle at the last side has the first apex, counted from mesh.halfedge_handle(face) on, and likewise in each part.
/// Effect:      the face keeps its halfedge and becomes the triangle at that halfedge; the other faces and the
///              diagonals are new, with default values of all properties. A face that is a triangle stays as it is.
/// Requires:    triangulate_face_blocker() with the same `keep` is empty.
/// Throws:      ContractViolation, and what weight() throws; the mesh is then unchanged.
/// Invalidates: nothing.
/// Δ:           E +k−3, F +k−3. The topology does not change.
template <TriangleWeight Weight>
TriangulateFaceEffect triangulate_face(Connectivity& mesh, Face face, Weight weight, Keep keep = Keep::simplicial) {
  const detail::Polygon polygon(mesh, face, keep);
  const auto apex = detail::least_triangulation(polygon, weight);
  if (!apex) detail::enforce("triangulate_face", std::optional(polygon.reason()));
  return polygon.cut(mesh, *apex);
}

/// Triangulates a face of a mesh with points with the least total area. If the face is a simple polygon in a plane, and
/// `keep` forbids no diagonal, the triangles do not overlap, up to rounding.
template <HasPoints Mesh>
TriangulateFaceEffect triangulate_face(Mesh& mesh, Face face, Keep keep = Keep::simplicial) {
  return triangulate_face(mesh, face, TriangleArea(mesh), keep);
}

}  // namespace meshops
