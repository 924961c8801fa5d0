// What:  reports the topology of a mesh, or of any soup of faces, in total and per component.
// Law:   euler = vertices − edges + faces = betti[0] − betti[1] + betti[2], in total and per component.
// Cost:  near-linear; for a soup, also an elimination over the pieces that meet in non-manifold edges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/progress.h"
#include "meshops/topology/polygon_soup.h"

namespace meshops {

/// Betti numbers b₀, b₁, b₂: the numbers of components, of independent loops, and of independent closed surfaces.
using BettiNumbers = std::array<long, 3>;

/// Report on a piece of surface: faces that are connected through edges of exactly two faces. Each fan on a point
/// counts as a vertex. Each face at a non-manifold edge counts the edge as an edge of its own.
struct ComponentReport {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t boundary_curves = 0;
  bool orientable = true;
  std::size_t first_face = 0;  ///< the least face, which identifies the piece

  long euler() const { return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(faces); }
  /// Returns the genus g, for which χ = 2 − 2g − curves; nothing if the piece is not orientable.
  std::optional<long> genus() const {
    if (!orientable) return std::nullopt;
    return (2 - euler() - static_cast<long>(boundary_curves)) / 2;
  }
  /// Returns the Betti numbers over Z/2. A closed piece has a 2-cycle, whether it is orientable or not.
  BettiNumbers betti() const {
    const long closed = boundary_curves == 0 ? 1 : 0;
    return {1, 1 + closed - euler(), closed};
  }
  friend bool operator==(const ComponentReport&, const ComponentReport&) = default;
};

/// Totals of the complex as it is given, and a report on each piece. In the totals, a point is one vertex, however many
/// fans stand on it, and an edge of a soup is a pair of points.
struct TopologyReport {
  std::size_t vertices = 0;  ///< number of points, including isolated points
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t components = 0;        ///< number of parts connected in any way; an isolated point is one part
  std::size_t solid_components = 0;  ///< number of pieces of surface: the size of `per_component`
  std::size_t boundary_curves = 0;   ///< total of all pieces; at a pinch, a curve stays on its fan
  std::optional<long> genus;       ///< total of all pieces; absent if a piece is not orientable or an edge non-manifold
  BettiNumbers betti = {0, 0, 0};  ///< over Z/2, of the whole complex as a space
  std::size_t pinches = 0;         ///< number of points on which several fans stand; non-manifold edges join fans
  std::size_t isolated = 0;        ///< number of points without a face
  std::vector<ComponentReport> per_component;  ///< in the order of their first faces

  long euler() const { return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(faces); }
  friend bool operator==(const TopologyReport&, const TopologyReport&) = default;
};

/// Reports on any soup. Faces that are degenerate, duplicate or out of range are ignored (find_defects() lists them).
/// Pieces end at non-manifold edges: the faces at such an edge count as separate in `solid_components`,
/// `boundary_curves` and `per_component`, but as connected in the other totals.
/// Throws: ContractViolation as require_parted() does, or for 2³⁰ or more corners, points or faces; Cancelled.
MESHOPS_API TopologyReport report(const PolygonSoup& soup, const GoOn& go_on = {});

/// Reports on a mesh. `point_of_vertex` has the point of each vertex, as build_mesh() returns it; if it is empty, each
/// vertex stands on its own point. A vertex with several fans, as OpenMesh's readers leave it, counts as a pinch, which
/// no piece and no curve passes. Edges are those of the mesh, even if several join the same points.
/// Requires: the only defects that validate() finds are vertices with several fans; not checked.
/// Throws:   ContractViolation unless `point_of_vertex` is empty or has a value below 2³¹ for each vertex; Cancelled.
/// Cost:     also linear in the greatest point.
MESHOPS_API TopologyReport report(const Connectivity& mesh, std::span<const std::uint32_t> point_of_vertex = {},
                                  const GoOn& go_on = {});

}  // namespace meshops
