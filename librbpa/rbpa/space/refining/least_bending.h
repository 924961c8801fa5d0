// What:   the places of points between fixed ones at which a surface bends least.
// How:    of each point that is listed, and its neighbours, the second difference: the weighted mean of the neighbours less the
//         point, with weights that are inverse to distances. The sum of their squares is least; a sparse system.
// Source: Kobbelt, Campagna, Vorsatz, Seidel, Interactive multi-resolution modeling on arbitrary meshes (1998).
// Cost:   for n free points on a surface about n^1.5.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

struct BendingNeighbor {
  static constexpr std::uint32_t fixed = 0xffffffff;
  Vector3<double> place;
  std::uint32_t free;  ///< which of the free points it is, or fixed
};

class BendingRows {
 public:
  explicit BendingRows(std::size_t free) : free_(free) {}

  /// The second difference at a point. Neighbours at its own place count for nothing.
  void add(const Vector3<double>& place, std::uint32_t free, std::span<const BendingNeighbor> neighbors);

  /// The places of the free points; nothing where they are not determined.
  std::optional<std::vector<Vector3<double>>> least() const;

 private:
  struct Entry {
    std::uint32_t row, column;
    double factor;
  };

  std::size_t free_;
  std::vector<Entry> entries_;
  std::vector<Vector3<double>> known_;  // of each row: what is to be the sum of its entries
};

}  // namespace rbpa::space
