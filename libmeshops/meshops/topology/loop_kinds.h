// What:   which loops of a closed surface in space are handle loops, and which tunnel loops.
// How:    a loop bounds something inside of its component if it links no loop of a basis that is lifted off it outward,
//         and something outside if none of these links it, once it is lifted itself: inside and outside are dual to
//         each other by linking numbers (Alexander). A loop that links one of another component bounds on neither side:
//         what it would bound crosses that one. Linking numbers are Gauss sums over pairs of segments, rounded.
// Law:    a meridian of a torus is a handle loop, what goes around its hole a tunnel loop; turning the surface inside
//         out changes nothing. Of two tori linked like a chain, what goes around their holes is neither.
// Cost:   for each two loops whose boxes meet, the product of their edges.
// Source: Dey, Li, Sun, Cohen-Steiner, Computing geometry-aware handle and tunnel loops in 3D models (2008) for the terms; Klenin and
//         Langowski, Computation of writhe in modeling of supercoiled DNA (2000) for the sum.
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

enum class LoopKind : std::uint8_t {
  handle,   ///< it bounds inside of the surface and not outside: around a handle
  tunnel,   ///< it bounds outside and not inside: through a tunnel
  neither,  ///< it bounds on neither side: a sum of both kinds, or another component goes through it
  both,     ///< it bounds on both sides, and so on the surface, or is no loop of a basis
  unknown,  ///< of a component with a boundary; or the surface is folded flat there, or so thin that a sum is near no integer
};

/// Of each loop. Positions of vertices by index; inside is where the normals of a component of positive volume do not point.
/// Components of which no loop is given are not there: the loops of one alone have the kinds that it has alone.
/// Requires: validate(mesh) is empty; finite positions; a surface that does not cross itself; among the loops a basis for each component
///           that has some, such as homology() finds.
/// Throws:   ContractViolation where there is no position of each vertex, or a loop is empty, has a halfedge that is
///           not there, or does not close; Cancelled.
MESHOPS_API std::vector<LoopKind> loop_kinds(const Connectivity& mesh, std::span<const std::array<double, 3>> positions,
                                             std::span<const Loop> loops, const GoOn& go_on = {});

}  // namespace meshops
