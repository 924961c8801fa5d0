// What:   classifies loops of a closed surface in space as handle loops and tunnel loops.
// How:    inside and outside are dual to each other by linking numbers (Alexander). A loop bounds a surface inside its
//         component if the loop links no loop of a basis that is lifted off the surface outward. A loop bounds a
//         surface outside if the loop, lifted outward, links no loop of the basis. A loop that links a loop of another
//         component bounds on neither side, because every surface that it would bound crosses the other loop. Linking
//         numbers are Gauss sums over pairs of segments, rounded.
// Law:    a meridian of a torus is a handle loop, and a loop around its hole is a tunnel loop. Turning the surface
//         inside out changes no kind. For two tori linked like a chain, loops around their holes are neither.
// Cost:   linear in the mesh; also, for each two loops whose boxes intersect, the product of their numbers of edges.
// Source: Dey, Li, Sun, Cohen-Steiner, Computing geometry-aware handle and tunnel loops in 3D models (2008) for the
//         terms; Klenin and Langowski, Computation of writhe in modeling of supercoiled DNA (2000) for the sum.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/progress.h"
#include "meshops/topology/homology.h"

namespace meshops {

/// Kind of a loop on a component, given by the sides on which the loop bounds a surface.
enum class LoopKind : std::uint8_t {
  handle,   ///< the loop bounds a surface inside but not outside: it runs around a handle
  tunnel,   ///< the loop bounds a surface outside but not inside: it runs through a tunnel
  neither,  ///< the loop bounds on neither side: it sums both kinds, or another component passes through it
  both,     ///< the loop bounds on both sides, and so on the surface itself; it is in no basis
  unknown,  ///< the component has a boundary, or a sum is near no integer: the surface is folded flat or too thin
};

/// Returns the kind of each loop. `positions` has the position of each vertex, by vertex index. The inside of a
/// component is its bounded side. Components without a given loop are ignored: if all loops lie on one component, their
/// kinds are those that they would have without the other components.
/// Requires: validate(mesh) is empty; positions are finite; the surface does not cross itself; the loops on each
///           component include a basis, for example that of homology(). Not checked.
/// Throws:   ContractViolation if `positions` has fewer entries than the mesh has vertices, or a loop is empty, has a
///           halfedge that does not exist or is deleted, or does not close; Cancelled.
MESHOPS_API std::vector<LoopKind> loop_kinds(const Connectivity& mesh, std::span<const std::array<double, 3>> positions,
                                             std::span<const Loop> loops, const GoOn& go_on = {});

}  // namespace meshops
