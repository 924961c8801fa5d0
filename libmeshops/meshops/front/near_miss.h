// What: compile-time checks for members of a policy or a visitor that have the name of an optional member but another
//       signature, and would be ignored without an error.
#pragma once

#include <concepts>
#include <type_traits>

#include "meshops/front/policy.h"
#include "meshops/front/visitor.h"

namespace meshops::detail {

/// A name that a class has, however it is declared, is ambiguous beside that of another base.
struct NamedKey {
  int key;
};
struct NamedGlues {
  int glues;
};
struct NamedRekeys {
  int rekeys_neighbours;
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
      &Beside<Policy, NamedRekeys>::rekeys_neighbours;
    };
  else
    return requires { &Policy::rekeys_neighbours; };
}

template <typename Policy>
constexpr bool misses_key = names_key<std::remove_cv_t<Policy>>() && !OrderedFrontPolicy<Policy>;
template <typename Policy>
constexpr bool misses_glues = names_glues<std::remove_cv_t<Policy>>() && !GluingFrontPolicy<Policy>;

/// `false` is an answer, also of a policy without keys.
template <typename Policy>
constexpr bool misses_rekeys = names_rekeys<std::remove_cv_t<Policy>>() && !RekeyingFrontPolicy<Policy> && !requires {
  requires !std::bool_constant<Policy::rekeys_neighbours>::value;
};

/// The visitor overrides an event of curves, but would not receive it.
template <typename Visitor>
constexpr bool misses_curves() {
  if constexpr (std::derived_from<Visitor, FrontVisitor>)
    return !Visitor::follows_curves &&
           !(
               requires {
                 requires std::same_as<decltype(&Visitor::curve_begun), decltype(&FrontVisitor::curve_begun)>;
               } &&
               requires {
                 requires std::same_as<decltype(&Visitor::curves_joined), decltype(&FrontVisitor::curves_joined)>;
               } &&
               requires {
                 requires std::same_as<decltype(&Visitor::curve_split), decltype(&FrontVisitor::curve_split)>;
               } &&
               requires {
                 requires std::same_as<decltype(&Visitor::curve_closed), decltype(&FrontVisitor::curve_closed)>;
               });
  else
    return false;
}

}  // namespace meshops::detail
