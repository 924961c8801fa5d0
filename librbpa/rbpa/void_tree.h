// What:   all voids of points in space at every radius, as a tree: each with the radius at which it closes, the one at which it is filled, and the void, or the
//         outside, that it is parted from when it closes. What closes only above a radius is a pocket there, with the triangle that closes it for its mouth.
// Law:    a void of the complex at alpha is one node with closes ≤ alpha < filled, and nodes other than these are none. A function of the set of points, but for the
//         simplices where radii are equal.
// Cost:   a sort of the tetrahedra, and union–find; with full walls moreover the radius of each triangle.
// Source: Delfinado, Edelsbrunner (1995); Edelsbrunner, Facello, Liang, On the definition and the construction of pockets in macromolecules (1998);
//         docs/persistence_in_space.md.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/solid.h"
#include "rbpa/surface.h"
#include "rbpa/voids.h"

namespace rbpa {

struct VoidNode {
  double closes = 0, filled = 0;  ///< a void for closes ≤ alpha < filled
  double volume = 0;              ///< when it closes
  Triangle mouth =
      {};  ///< ascending corners of the triangle that closes it; of VoidWalls::solid the last one of a tetrahedron
  std::uint32_t last = 0;    ///< the tetrahedron that fills it at last
  std::uint32_t parent = 0;  ///< the void that it is parted from, by number, or none: the outside
};

struct VoidTree {
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<VoidNode> nodes;  ///< by `closes`, parents before what is parted from them
  /// Of each tetrahedron, the node that it is in just below its radius; none: the outside, or one that is filled as it closes.
  std::vector<std::uint32_t> node_of;

  /// The void that a tetrahedron is in at a radius below its own, or none. Cost: its depth.
  std::uint32_t void_at(double alpha, std::uint32_t tetrahedron) const {
    std::uint32_t node = node_of[tetrahedron];
    while (node != none && nodes[node].closes > alpha) node = nodes[node].parent;
    return node;
  }
};

/// Requires: the tetrahedra of solid() of these points at infinity, with neighbors, and their circumradii; or those of solid_filtration(), which are near
///           each other in memory. Threads, as in SolidOptions, share the radii of triangles.
/// Throws:   ContractViolation where they visibly are not; Cancelled when `go_on`, which is called every few milliseconds, returns false. Empty: never called.
RBPA_API VoidTree void_tree(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                            VoidWalls walls = VoidWalls::full, unsigned threads = 0,
                            const std::function<bool()>& go_on = {});

/// Of each of the voids at alpha, as voids() or full_voids() return them with their boundary, its node in the tree of the same walls.
/// Requires: the triangulation of the tree, and its radii. Throws: ContractViolation where a void is not found.
RBPA_API std::vector<std::uint32_t> nodes_of(const VoidTree& tree, const Solid& delaunay, std::span<const double> radii,
                                             double alpha, const Surface& boundary, std::span<const SolidVoid> voids);

}  // namespace rbpa
