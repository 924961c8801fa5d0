// What:   the simplification engine: repeatedly collapses the edge of least cost, as a policy decides.
// Law:    whatever the policy returns, a sound mesh is sound after every collapse, and its topology does not change:
//         components, genus, orientation and Betti numbers; every boundary curve stays one curve. If the run ends as
//         exhausted, and if the policy decides by the triangles at the ends of an edge, then every edge left has no
//         cost, is not allowed, or is refused by collapse_blocker() toward the end that would survive.
// Cost:   for n edges, n costs and n log n steps of a queue; for each collapse, also the costs of the edges at the
//         survivor, and of edges at the neighbors of the survivor that have no cost or did not collapse in their turn.
// Source: Hoppe, Progressive meshes (1996); Garland and Heckbert (1997).
#pragma once

#include <concepts>
#include <optional>
#include <type_traits>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/simplify/simplify_policy.h"
#include "meshops/simplify/simplify_run.h"
#include "meshops/simplify/simplify_visitor.h"

namespace meshops {

/// Returns why the mesh cannot be simplified, or nothing when it can. The reasons: the mesh lacks status of some kind,
/// or a face is not a triangle (triangulate_face() can cut it). Cost: linear in the number of faces.
MESHOPS_API std::optional<Blocker> simplify_blocker(const Connectivity& mesh);

/// Collapses edges until a limit of the options is reached, the policy stops the run, or no edge is left that can be
/// collapsed. Deleted elements stay in the mesh, marked deleted, until garbage_collection().
/// Requires: simplify_blocker() is empty; the mesh is sound, except that vertices may have several fans (not checked);
///           the visitor derives from SimplifyVisitor.
/// Throws:   ContractViolation if simplify_blocker() has a reason, if options.cost is NaN, if a cost or a place is not
///           finite, if a survivor is not an end of its edge, or if a callback adds elements to the mesh or removes
///           some. Whatever the policy or the visitor throws; Cancelled. The mesh is then as after the last collapse,
///           or as at the beginning, except for values that callbacks wrote.
template <std::derived_from<Connectivity> Mesh, SimplifyPolicy<Mesh> Policy, typename Visitor = SimplifyVisitor>
SimplifyResult simplify(Mesh& mesh, Policy&& policy, const SimplifyOptions& options = {}, Visitor&& visitor = {}) {
  using P = std::remove_reference_t<Policy>;
  using V = std::remove_reference_t<Visitor>;
  constexpr bool merges = MergingPolicy<P, Mesh> || !requires { &P::merge; };
  static_assert(merges, "the policy's merge is ignored: expected merge(Mesh&, const WeldEffect&, place)");
  constexpr bool chooses = ChoosingPolicy<P, Mesh> || !requires { &P::survivor; };
  static_assert(chooses, "the policy's survivor is ignored: expected Vertex survivor(const Mesh&, Edge, place)");
  constexpr bool ends = StoppingPolicy<P, Mesh> || !requires { &P::stops; };
  static_assert(ends, "the policy's stops is ignored: expected bool stops(const Mesh&, Edge, double cost)");
  static_assert(std::derived_from<std::remove_cv_t<V>, SimplifyVisitor>, "the visitor is no SimplifyVisitor");
  static_assert(std::same_as<std::remove_cv_t<V>, SimplifyVisitor> || !detail::KeepsSimplifyEvents<V>,
                "the visitor has no event: expected collapsed, refused or disallowed");
  detail::enforce("simplify", simplify_blocker(mesh));
  return detail::SimplifyRun<Mesh, P, V>(mesh, policy, visitor, options).run();
}

}  // namespace meshops
