// What: which triangle ends each tunnel, and which cycles it is that they end.
// How:  columns of the boundary matrix, with coefficients in Z/2, are reduced in any order, here along the curve through space: where the pivot of one is
//       that of a later triangle, they change places, and the later one goes on. Columns with two or more triangles in them are kept; others are their
//       triangle's boundary. Edges that end a component can be no pivot, and are left out of all columns: a cycle is known by its other edges.
// Law:  the pairs do not depend on the order, as the reduced matrix has the same pivots in any. The columns of triangles up to one span the boundaries of the
//       complex up to it.
// Cost: nearly linear in practice: most columns are never added to.
// Source: de Silva, Morozov, Vejdemo-Johansson, Dualities in persistent (co)homology (2011); Bauer, Kerber, Reininghaus, Clear and compress (2014).
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/steps.h"
#include "rbpa/solid_filtration.h"
#include "rbpa/space/persistence/column.h"

namespace rbpa::space {

class Tunnels {
 public:
  /// `order` has the edges by alpha, of which those in `joins` make no tunnel; triangles in `makes_void` end none. Keeps a reference to the filtration.
  Tunnels(const SolidFiltration& filtration, std::span<const std::uint32_t> order, const std::vector<bool>& joins,
          const std::vector<bool>& makes_void, Steps& step);

  /// The triangle that ends the tunnel that an edge makes; Solid::none where it makes none.
  std::uint32_t ended_by(std::uint32_t edge) const { return owner_[edge]; }
  /// That of each edge; then nothing else is left, and its memory is free.
  std::vector<std::uint32_t> all_ended_by() && {
    Tunnels taken = std::move(*this);
    return std::move(taken.owner_);
  }
  /// Whether an edge comes before another.
  bool is_before(std::uint32_t edge, std::uint32_t other) const { return rank_[edge] < rank_[other]; }
  /// Edges of a cycle that the triangle at the end of this tunnel makes a boundary, without those that end components.
  std::vector<std::uint32_t> cycle(std::uint32_t edge) const;
  /// Whether a cycle is a boundary of triangles up to this one. Edges that come twice are not in it.
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
  std::vector<std::uint32_t> rank_;   // of each edge, from 1 on
  std::vector<bool> joins_;           // of each edge: it ends a component
  std::vector<std::uint32_t> owner_;  // of each edge that is a pivot: the triangle
  std::vector<std::uint32_t> kept_;   // of each such edge: which of the columns, or none: the triangle's boundary
  std::vector<std::vector<ColumnEntry>> columns_;
  std::vector<std::uint32_t> free_;
  Column column_;
};

}  // namespace rbpa::space
