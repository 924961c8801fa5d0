// What:   builds the tree of all voids of points in space at every radius. A void has the radii at which it closes and
//         is filled; the parent of a void is the larger void, or the outside, from which the void separates as it
//         closes. At smaller radii, the void is a pocket, whose mouth is the triangle that closes the void.
// Law:    the voids of the complex at alpha are the nodes with closes ≤ alpha < filled, each node one void. The tree is
//         a function of the set of points; if radii are equal, mouth, last and the order of nodes depend on the numbers
//         of simplices.
// Cost:   a sort of the tetrahedra, and union–find; with ComplexKind::full also the radius of each triangle.
// Source: Delfinado, Edelsbrunner (1995); Edelsbrunner, Facello, Liang, On the definition and the construction of
//         pockets in macromolecules (1998); docs/explanation/filtration_and_persistence.md, section 11.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/voids.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// A void over a range of alpha, in units of the points.
struct VoidNode {
  double closes = 0, filled = 0;  ///< radii: the node is a void for closes ≤ alpha < filled
  double volume = 0;              ///< volume of the void at `closes`, in cubed units, with rounding errors
  /// The corners of the triangle that closes the void, ascending; with ComplexKind::solid, a triangle of the
  /// tetrahedron that closes the void.
  Triangle mouth = {};
  std::uint32_t last = 0;    ///< the last of the tetrahedra that fill the void: its radius is `filled`
  std::uint32_t parent = 0;  ///< the node from which this one separates; VoidTree::none: the outside
};

/// The voids at every radius as nodes of a forest, and the node of each tetrahedron.
struct VoidTree {
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<VoidNode> nodes;  ///< sorted by `closes`; parents come before children
  /// For each tetrahedron, the node of the void that contains the tetrahedron at radii just below its own; none if no
  /// void does.
  std::vector<std::uint32_t> node_of;

  /// Returns the node of the void that contains a tetrahedron at `alpha`, or none. Requires: the tetrahedron exists,
  /// and alpha is below its radius; neither is checked. Cost: the depth of the node.
  std::uint32_t void_at(double alpha, std::uint32_t tetrahedron) const {
    std::uint32_t node = node_of[tetrahedron];
    while (node != none && nodes[node].closes > alpha) node = nodes[node].parent;
    return node;
  }
};

/// Builds the tree of the voids of the solid or the full complex. `threads` is the maximum number of threads that
/// compute radii of triangles; 0: all processors. The tree is empty if there are no tetrahedra.
/// Requires: `delaunay` is solid() of `points` at infinity, with neighbors, and `radii` are its circumradii(); or they
///           are `delaunay` and `tetrahedron_alpha` of solid_filtration(), which is faster.
/// Throws:   ContractViolation when the numbers of tetrahedra, rows of neighbors and radii differ, a corner is not a
///           point, or a neighbor does not exist or does not share the face; Cancelled.
RBPA_API VoidTree void_tree(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                            ComplexKind walls = ComplexKind::full, MaxThreads threads = 0, const GoOn& go_on = {});

/// Returns the node of each of `voids`, in their order.
/// Requires: `delaunay` and `radii` made the tree. `voids` at `alpha`, and their `boundary`, are those of voids() if
///           the tree is of ComplexKind::solid, those of full_voids() (rbpa/space/balls/full_topology.h) if the tree is
///           of ComplexKind::full. It is not checked that `voids` and `boundary` belong together.
/// Throws:   ContractViolation when the numbers of tetrahedra and radii differ, a void has no triangle of the boundary,
///           or a void is not found in the tree.
/// Cost:     linear in the tetrahedra; a search among the voids for faces that may be at a void.
RBPA_API std::vector<std::uint32_t> nodes_of(const VoidTree& tree, const Solid& delaunay, std::span<const double> radii,
                                             double alpha, const Surface& boundary, std::span<const SolidVoid> voids);

}  // namespace rbpa
