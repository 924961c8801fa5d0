// What:   the cases of gluing, and the change of the counts of a mesh by each handle operator.
// Law:    on every sound mesh, delta_of(c) is the exact change by every glue() of case c, and each delta_of_…() the
//         exact change by the operator of its name.
// Source: Lewiner, Lopes, Medeiros, Tavares, Velho, Topological mesh operators (CAGD 27, 2010).
#pragma once

#include <string_view>

#include "meshops/core/delta.h"

namespace meshops {

/// The five cases of gluing two boundary edges.
enum class GlueCase {
  join,         ///< edges of two components, which become one component; their two curves become one curve
  split_curve,  ///< edges of one curve that are not adjacent: the curve becomes two curves
  handle,       ///< edges of two curves of one component: the component gets a handle
  zip,          ///< adjacent edges of one curve: the vertex between them becomes inner
  close         ///< the last two edges of a curve, which vanishes
};

/// Returns the name of a case in words, for example "split curve".
constexpr std::string_view name(GlueCase c) {
  constexpr std::string_view names[] = {"join", "split curve", "handle", "zip", "close"};
  return names[static_cast<int>(c)];
}

/// Returns the delta of create_triangle(). Each function below returns the delta of the operator of its name.
constexpr Delta delta_of_create() { return {.vertices = 3, .edges = 3, .faces = 1, .curves = 1, .components = 1}; }

constexpr Delta delta_of_destroy() { return -delta_of_create(); }
constexpr Delta delta_of_close_curve() { return {.faces = 1, .curves = -1}; }
constexpr Delta delta_of_open_curve() { return -delta_of_close_curve(); }

/// Returns the delta of a glue() of case `c`.
constexpr Delta delta_of(GlueCase c) {
  switch (c) {
    case GlueCase::join:
      return {.vertices = -2, .edges = -1, .curves = -1, .components = -1};
    case GlueCase::split_curve:
      return {.vertices = -2, .edges = -1, .curves = 1};
    case GlueCase::handle:
      return {.vertices = -2, .edges = -1, .curves = -1, .genus = 1};
    case GlueCase::zip:
      return {.vertices = -1, .edges = -1};
    case GlueCase::close:
      return {.edges = -1, .curves = -1};
  }
  return {};
}

}  // namespace meshops
