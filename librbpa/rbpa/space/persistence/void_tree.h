// What:   all voids of points in space at every radius, as a tree: each void with the radii at which it closes and is
//         filled, and with the larger void, or the outside, from which it separates when it closes. Below the radius at
//         which it closes, a void is a pocket, with the triangle that closes it for its mouth.
// Law:    a void of the complex at alpha is one node with closes ≤ alpha < filled, and every such node is a void. A
//         function of the set of points, except for the simplices if radii are equal.
// Cost:   a sort of the tetrahedra, and union–find; with full walls also the radius of each triangle.
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

struct VoidNode {
  double closes = 0, filled = 0;  ///< it is a void for closes ≤ alpha < filled
  double volume = 0;              ///< volume when it closes
  /// The corners of the triangle that closes it, ascending; with ComplexKind::solid, the last triangle of the
  /// tetrahedron that closes it.
  Triangle mouth = {};
  std::uint32_t last = 0;    ///< the last tetrahedron that fills it
  std::uint32_t parent = 0;  ///< the node from which it separates, or none: the outside
};

struct VoidTree {
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<VoidNode> nodes;  ///< sorted by `closes`; parents come before children
  /// For each tetrahedron, the node that contains it just below its radius; none if it is then in the outside, or in a
  /// void that is filled as it closes.
  std::vector<std::uint32_t> node_of;

  /// Returns the void that contains a tetrahedron at a radius below its own, or none. Cost: its depth.
  std::uint32_t void_at(double alpha, std::uint32_t tetrahedron) const {
    std::uint32_t node = node_of[tetrahedron];
    while (node != none && nodes[node].closes > alpha) node = nodes[node].parent;
    return node;
  }
};

/// Builds the tree. Threads share the radii of triangles.
/// Requires: the tetrahedra of solid() of these points at infinity, with neighbors, and their circumradii; or those of
///           solid_filtration(), which are near each other in memory.
/// Throws:   ContractViolation when they visibly are not; Cancelled.
RBPA_API VoidTree void_tree(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                            ComplexKind walls = ComplexKind::full, MaxThreads threads = 0, const GoOn& go_on = {});

/// Returns for each void at alpha, as voids() or full_voids() return them with their boundary, its node in the tree of
/// the same walls.
/// Requires: the triangulation of the tree, and its radii.
/// Throws:   ContractViolation when a void is not found.
RBPA_API std::vector<std::uint32_t> nodes_of(const VoidTree& tree, const Solid& delaunay, std::span<const double> radii,
                                             double alpha, const Surface& boundary, std::span<const SolidVoid> voids);

}  // namespace rbpa
