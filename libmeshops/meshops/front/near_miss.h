// What: compile-time checks that find members of a policy or a visitor which would be ignored without an error.
// How:  a policy misses a member that has the name of an optional member but another form. A visitor misses a member
//       that has nearly the name of an event, or that is an event which the visitor does not receive.
// Law:  each misses_…, a constant or a function, is true if there is such a member; misses_events() is also true for a
//       class derived from FrontVisitor without an event. advance() (front/engine.h) asserts that all are false.
#pragma once

#include <array>
#include <concepts>
#include <type_traits>

#include "meshops/front/policy.h"
#include "meshops/front/visitor.h"

namespace meshops::detail {

/// Base with one member name. In a class that derives from this base and from a policy (Beside), the name is ambiguous
/// if the policy has a member of that name, in whatever form.
struct NamedKey {
  int key;
};
struct NamedGlues {
  int glues;
};
struct NamedRekeys {
  int rekeys_neighbors;
};
template <typename Policy, typename Named>
struct Beside : Policy, Named {};

template <typename Policy>
constexpr bool names_key() {
  if constexpr (std::is_class_v<Policy> && !std::is_final_v<Policy>) return !requires {
      &Beside<Policy, NamedKey>::key;
    };
  else
    return requires { &Policy::key; };
}
template <typename Policy>
constexpr bool names_glues() {
  if constexpr (std::is_class_v<Policy> && !std::is_final_v<Policy>) return !requires {
      &Beside<Policy, NamedGlues>::glues;
    };
  else
    return requires { &Policy::glues; };
}
template <typename Policy>
constexpr bool names_rekeys() {
  if constexpr (std::is_class_v<Policy> && !std::is_final_v<Policy>) return !requires {
      &Beside<Policy, NamedRekeys>::rekeys_neighbors;
    };
  else
    return requires { &Policy::rekeys_neighbors; };
}

template <typename Policy>
constexpr bool misses_key = names_key<std::remove_cv_t<Policy>>() && !OrderedFrontPolicy<Policy>;
template <typename Policy>
constexpr bool misses_glues = names_glues<std::remove_cv_t<Policy>>() && !GluingFrontPolicy<Policy>;

/// True if the policy has a member rekeys_neighbors that would be ignored. The value `false` is always allowed, even
/// for a policy without a member key.
template <typename Policy>
constexpr bool misses_rekeys = names_rekeys<std::remove_cv_t<Policy>>() && !RekeyingFrontPolicy<Policy> && !requires {
  requires !std::bool_constant<Policy::rekeys_neighbors>::value;
};

/// KeepsEvents: visitor that overrides no event of triangles and edges. KeepsCurves: visitor that overrides no event of
/// curves. A member with the name of an event counts as an override even if it has another form.
template <typename V>
concept KeepsEvents = std::same_as<decltype(&V::seeded), decltype(&FrontVisitor::seeded)> &&
    std::same_as<decltype(&V::attached), decltype(&FrontVisitor::attached)> &&
    std::same_as<decltype(&V::deferred), decltype(&FrontVisitor::deferred)> &&
    std::same_as<decltype(&V::frozen), decltype(&FrontVisitor::frozen)> &&
    std::same_as<decltype(&V::detached), decltype(&FrontVisitor::detached)> &&
    std::same_as<decltype(&V::refused), decltype(&FrontVisitor::refused)> &&
    std::same_as<decltype(&V::seed_refused), decltype(&FrontVisitor::seed_refused)>;
template <typename V>
concept KeepsCurves = std::same_as<decltype(&V::curve_begun), decltype(&FrontVisitor::curve_begun)> &&
    std::same_as<decltype(&V::curves_joined), decltype(&FrontVisitor::curves_joined)> &&
    std::same_as<decltype(&V::curve_split), decltype(&FrontVisitor::curve_split)> &&
    std::same_as<decltype(&V::curve_closed), decltype(&FrontVisitor::curve_closed)>;

/// Returns whether the visitor overrides an event of curves that the engine would not send to it.
template <typename Visitor>
constexpr bool misses_curves() {
  if constexpr (std::derived_from<Visitor, FrontVisitor>)
    return !Visitor::follows_curves && !KeepsCurves<Visitor>;
  else
    return false;
}

/// Visitor with a member whose name is nearly that of an event, and which can be called with the event's arguments.
template <typename V>
concept MisnamesEvent = requires(V v, const Front& f, const InsertedTriangle& t) {
  v.seed(f, t);
}
|| requires(V v, const Front& f, Halfedge h, const InsertedTriangle& t) { v.attach(f, h, t); }
|| requires(V v, const Front& f, Halfedge h) { v.defer(f, h); }
|| requires(V v, const Front& f, Halfedge h) { v.defered(f, h); }
|| requires(V v, const Front& f, Halfedge h) { v.freeze(f, h); }
|| requires(V v, const Front& f, Halfedge h) { v.freezed(f, h); }
|| requires(V v, const Front& f, Halfedge h) { v.froze(f, h); }
|| requires(V v, const Front& f, const DetachedTriangle& t) { v.detach(f, t); }
|| requires(V v, const Front& f, Halfedge h, const Refusal& r) { v.refuse(f, h, r); }
|| requires(V v, const Front& f, Halfedge h, const Refusal& r) { v.rejected(f, h, r); }
|| requires(V v, const Front& f, const std::array<Site, 3>& s, const Refusal& r) { v.refused_seed(f, s, r); }
|| requires(V v, const Front& f, const std::array<Site, 3>& s, const Refusal& r) { v.seed_rejected(f, s, r); }
|| requires(V v, const Front& f, Halfedge h) { v.curve_began(f, h); }
|| requires(V v, const Front& f, Halfedge h) { v.curve_joined(f, h); }
|| requires(V v, const Front& f, Halfedge h) { v.curves_split(f, h, h); }
|| requires(V v, const Front& f, Halfedge h) { v.curve_splitted(f, h, h); }
|| requires(V v, const Front& f) { v.curves_closed(f); };

/// Returns whether the visitor derives from FrontVisitor but has no event, or has a member named nearly like an event.
template <typename Visitor>
constexpr bool misses_events() {
  if constexpr (std::derived_from<Visitor, FrontVisitor> && !std::same_as<Visitor, FrontVisitor> &&
                !std::same_as<Visitor, CurveVisitor>)
    return (KeepsEvents<Visitor> && KeepsCurves<Visitor>) || MisnamesEvent<Visitor>;
  else
    return MisnamesEvent<Visitor>;
}

}  // namespace meshops::detail
