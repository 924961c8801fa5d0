// What: finds the triangle that ends each tunnel, and a cycle that becomes a boundary with this triangle.
// How:  columns of the boundary matrix, with coefficients in Z/2, are reduced in the order in which triangles are
//       numbered, along a curve through space. If a column has the pivot of the stored column of a later triangle, the
//       column replaces the stored one, whose reduction continues. Memory is used only for columns that are sums of
//       several boundaries; any other column is the boundary of its triangle. Edges that end a component cannot be
//       pivots and are in no column: the other edges of a cycle determine the cycle.
// Law:  the pairs do not depend on the order of reduction, as the reduced matrix has the same pivots in any order. The
//       columns of the triangles up to a given triangle span the boundaries of these triangles.
// Cost: nearly linear in practice: most columns are never added to another.
// Source: de Silva, Morozov, Vejdemo-Johansson, Dualities in persistent (co)homology (2011); Bauer, Kerber,
//         Reininghaus, Clear and compress (2014).
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/pairing/column.h"
#include "rbpa/space/persistence/solid_filtration.h"

namespace rbpa::space {

class Tunnels {
 public:
  /// Reduces the matrix. `order` has the edges sorted by alpha. Edges marked in `joins` make no tunnel; triangles
  /// marked in `makes_void` end no tunnel. Keeps a reference to `filtration`.
  Tunnels(const SolidFiltration& filtration, std::span<const std::uint32_t> order, const std::vector<bool>& joins,
          const std::vector<bool>& makes_void, Steps& step);

  /// Returns the triangle that ends the tunnel that an edge makes; Solid::none if there is no such tunnel or triangle.
  std::uint32_t ended_by(std::uint32_t edge) const { return owner_[edge]; }
  /// Returns ended_by() of each edge, and frees all other memory.
  std::vector<std::uint32_t> all_ended_by() && {
    Tunnels taken = std::move(*this);
    return std::move(taken.owner_);
  }
  /// Returns whether an edge comes before another in the filtration.
  bool is_before(std::uint32_t edge, std::uint32_t other) const { return rank_[edge] < rank_[other]; }
  /// Returns the edges, without those that end components, of a cycle around the tunnel that `edge` makes. The cycle
  /// becomes a boundary with the triangle ended_by(edge). Requires: ended_by(edge) is not Solid::none.
  std::vector<std::uint32_t> cycle(std::uint32_t edge) const;
  /// Returns whether the cycle `edges` is a boundary of triangles up to `triangle` in the filtration. Edges are added
  /// modulo 2: an edge that occurs twice in `edges` is not in the cycle.
  bool is_boundary(std::span<const std::uint32_t> edges, std::uint32_t triangle);

 private:
  struct Boundary;

  Boundary boundary_of(std::uint32_t triangle) const;
  bool is_triangle_before(std::uint32_t a, std::uint32_t b) const;
  void reduce(std::uint32_t triangle);
  void add_column_of(std::uint32_t edge);
  void keep(std::uint32_t edge, std::uint32_t triangle, std::vector<ColumnEntry> column);
  std::vector<ColumnEntry> released(std::uint32_t edge);

  const SolidFiltration& filtration_;
  std::vector<std::uint32_t> rank_;   // for each edge: its rank in the filtration, from 1
  std::vector<bool> joins_;           // for each edge: whether it ends a component
  std::vector<std::uint32_t> owner_;  // for each edge: the triangle of the column with this pivot, or none
  // For each edge: the index in columns_ of the column with this pivot; none if the column is the boundary of owner_.
  std::vector<std::uint32_t> kept_;
  std::vector<std::vector<ColumnEntry>> columns_;
  std::vector<std::uint32_t> free_;
  Column column_;
};

}  // namespace rbpa::space
