// What:   the functions by which simplify() (simplify/simplify.h) decides: the cost of an edge, the place of the vertex
//         to which the edge collapses, and whether the collapse is allowed.
// Source: Garland and Heckbert, Surface simplification using quadric error metrics (1997).
#pragma once

#include <concepts>
#include <optional>
#include <type_traits>
#include <utility>

#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"

namespace meshops {

/// Policy of a simplification: the policy decides geometry, the engine decides topology. A policy has four functions:
///   cost(mesh, e)           returns the cost of a collapse of the edge e, a finite number; nothing for an edge that
///                           must not collapse. The least cost comes first
///   place(mesh, e)          returns the place of the vertex to which e would collapse: a value of any type, for
///                           example a point. Floating-point numbers and ranges of them must be finite; so must values
///                           of a type whose namespace declares a function bool is_finite(place)
///   allows(mesh, e, place)  returns whether e may collapse to this place
///   key(mesh, v)            returns a key of the vertex that does not depend on its number, for example its
///                           coordinates as a std::array.
///                           Edges of equal cost are ordered by the keys of their ends. If all keys differ and no two
///                           edges join the same vertices, the result does not depend on the numbers of elements
/// The engine computes the cost of every edge at the beginning. It computes the cost of an edge again after an end of
/// the edge was merged; if the edge has no cost or did not collapse in its turn, also after a neighbor of an end was
/// merged. Other changes of triangles do not change costs. place() and allows() are called in the turn of the edge.
/// None of the four functions may change the mesh.
template <typename P, typename Mesh>
concept SimplifyPolicy = requires(P policy, const Mesh& mesh, Edge e, Vertex v) {
  { policy.cost(mesh, e) } -> std::convertible_to<std::optional<double>>;
  { policy.allows(mesh, e, policy.place(mesh, e)) } -> std::same_as<bool>;
  { policy.key(mesh, v) } -> std::totally_ordered;
};

/// Type of the places that a policy returns.
template <typename P, typename Mesh>
using PlaceOf = std::remove_cvref_t<decltype(std::declval<P&>().place(std::declval<const Mesh&>(), Edge()))>;

/// Policy that keeps data for vertices, and merges the data of the two ends of an edge:
///   merge(mesh, effect, place)  is called after an edge collapsed. It places the surviving vertex, and merges the data
///                               that the policy keeps for the two vertices. It may write points and properties of the
///                               mesh, but must not change links. If it throws, the collapse is undone, but not what
///                               merge() wrote
/// Without merge(), the engine sets the point of the survivor to the place if the mesh has points; the place must then
/// convert to a point.
template <typename P, typename Mesh>
concept MergingPolicy = requires(P policy, Mesh& mesh, const WeldEffect& effect, const PlaceOf<P, Mesh>& place) {
  policy.merge(mesh, effect, place);
};

/// Policy that chooses which vertex stays:
///   survivor(mesh, e, place)  returns the end of e that keeps its handle and its properties; the other end is removed
/// Without survivor(), the end of the lesser key stays; for equal keys, the end of the lower handle.
template <typename P, typename Mesh>
concept ChoosingPolicy = requires(P policy, const Mesh& mesh, Edge e, const PlaceOf<P, Mesh>& place) {
  { policy.survivor(mesh, e, place) } -> std::same_as<Vertex>;
};

/// Policy that ends the run:
///   stops(mesh, e, cost)  returns whether the run ends before the next edge, e, collapses at this cost
template <typename P, typename Mesh>
concept StoppingPolicy = requires(P policy, const Mesh& mesh, Edge e, double cost) {
  { policy.stops(mesh, e, cost) } -> std::same_as<bool>;
};

/// Policy that declares a bool `costs_grow`. The value true promises that the cost of an edge never falls when one of
/// its ends is merged, as with sums of quadrics. The engine then computes the cost of a waiting edge again only in its
/// turn.
template <typename P>
concept GrowingPolicy = requires(const P policy) {
  { policy.costs_grow } -> std::convertible_to<bool>;
};

}  // namespace meshops
