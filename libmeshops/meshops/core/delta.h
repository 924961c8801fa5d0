// What:   the change that an operator makes to the counts of a mesh.
// Law:    the delta of an operator is the exact change of TopologyCounts (topology/count.h), on every sound mesh; only
//         the number of isolated vertices has no entry.
// Source: Lewiner, Lopes, Medeiros, Tavares, Velho, Topological mesh operators (CAGD 27, 2010).
#pragma once

namespace meshops {

/// Change of the counts of a mesh: after minus before, without elements marked deleted. An isolated vertex counts as a
/// vertex and as a component.
struct Delta {
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  int curves = 0;  ///< boundary curves
  int components = 0;
  int genus = 0;  ///< sum of the genera of all components

  /// Returns the change of the Euler characteristic χ.
  constexpr int euler() const { return vertices - edges + faces; }
  /// Returns the delta of the inverse operator.
  constexpr Delta operator-() const { return {-vertices, -edges, -faces, -curves, -components, -genus}; }
  /// Returns the delta of two operators that are applied one after the other.
  friend constexpr Delta operator+(const Delta& a, const Delta& b) {
    return {a.vertices + b.vertices, a.edges + b.edges,           a.faces + b.faces,
            a.curves + b.curves,     a.components + b.components, a.genus + b.genus};
  }
  friend constexpr bool operator==(const Delta&, const Delta&) = default;
};

}  // namespace meshops
