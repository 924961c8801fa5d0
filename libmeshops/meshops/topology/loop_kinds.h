// What:   classifies loops of a closed surface in space as handle loops and tunnel loops.
// How:    inside and outside are dual to each other by linking numbers (Alexander). A loop bounds a surface inside of
//         its component if it links no loop of a basis after the basis is lifted off the surface outward. A loop bounds
//         a surface outside if, lifted itself, it links no loop of the basis. A loop that links one of another
//         component bounds on neither side, because the surface that it would bound crosses that other loop. Linking
//         numbers are Gauss sums over pairs of segments, rounded.
// Law:    a meridian of a torus is a handle loop, a loop around its hole is a tunnel loop; turning the surface inside
//         out changes nothing. For two tori linked like a chain, loops around their holes are neither.
// Cost:   linear in the mesh, and for each two loops whose boxes intersect, the product of their numbers of edges.
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

/// Kind of a loop on a component, by the sides on which the loop bounds a surface.
enum class LoopKind : std::uint8_t {
  handle,   ///< the loop bounds inside of the surface and not outside: it runs around a handle
  tunnel,   ///< the loop bounds outside and not inside: it runs through a tunnel
  neither,  ///< the loop bounds on neither side: it is a sum of both kinds, or another component passes through it
  both,     ///< the loop bounds on both sides, hence on the surface, and is in no basis
  unknown,  ///< the component has a boundary, or the surface is folded flat or too thin: a sum is near no integer
};

/// Returns the kind of each loop. `positions` has the position of each vertex by index. The inside of a component is
/// the bounded side. Components without a given loop are ignored: if all loops lie on one component, their kinds are
/// those that they have without the other components.
/// Requires: validate(mesh) is empty; positions are finite; the surface does not cross itself; the loops on a component
///           include a basis, such as homology() finds. Not checked.
/// Throws:   ContractViolation if `positions` has fewer entries than the mesh has vertices, or a loop is empty, has a
///           halfedge that does not exist or is deleted, or does not close; Cancelled.
MESHOPS_API std::vector<LoopKind> loop_kinds(const Connectivity& mesh, std::span<const std::array<double, 3>> positions,
                                             std::span<const Loop> loops, const GoOn& go_on = {});

}  // namespace meshops
