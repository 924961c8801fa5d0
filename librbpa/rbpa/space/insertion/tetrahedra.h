// What: tetrahedra in arrays, made for the question that insertion asks most: is a point inside a circumsphere?
// How:  each has the minors of the in-sphere determinant at hand, which leave four products for a point q:
//
//                  | a − d   |a − d|² |
//           V(q) = | b − d   |b − d|² |  =  minor · (q − d, |q − d|²)        positive inside, for a, b, c, d positively oriented
//                  | c − d   |c − d|² |
//                  | q − d   |q − d|² |
//
//       A corner may be at infinity. Its row is (0, 0, 0, 1), the limit of one far away divided by its lift: the tetrahedron is a
//       ghost over a face of the hull, its sphere the half-space beyond, and V the same four products. Corner 3 is never at
//       infinity.
//
//         minor 32 | corner 16 | neighbor 16      a cache line
//         error 8                                 an array of its own
//
// Law:  |V computed − V| ≤ error, where the filter's bound is derived in docs/predicates.md, section 7.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "meshops/core/fresh_vector.h"

namespace rbpa::space {

/// A vertex: 0 is at infinity, others are points in the order of insertion, from 1 on.
using Vertex = std::uint32_t;
inline constexpr Vertex at_infinity = 0;

/// A face of a tetrahedron: 4 · (its number) + (the corner across).
using Face = std::uint32_t;

struct alignas(64) Tetrahedron {
  std::array<double, 4> minor;
  std::array<Vertex, 4> corner;
  std::array<Face, 4> neighbor;  ///< across from each corner, the same face as the neighbour has it

  bool is_ghost() const {  // corner 3 is a point
    return corner[0] == at_infinity || corner[1] == at_infinity || corner[2] == at_infinity;
  }
};

/// A bound for the error of V(q): constant + slope |q − d|². Two doubles of which the first 32 bits are kept, rounded up.
class ErrorBound {
 public:
  ErrorBound() = default;
  ErrorBound(double constant, double slope)
      : bits_(((std::bit_cast<std::uint64_t>(constant) >> 32U) + 1) |
              ((std::bit_cast<std::uint64_t>(slope) & high_bits) + low_one)) {}

  /// Of a tetrahedron that is no more: no number is within it.
  static ErrorBound deleted() {
    ErrorBound bound;
    bound.bits_ = ~std::uint64_t{0};
    return bound;
  }
  ErrorBound deleted_if(bool is_meant) const {
    ErrorBound bound;
    bound.bits_ = bits_ | -std::uint64_t{is_meant};
    return bound;
  }
  bool is_deleted() const { return bits_ == ~std::uint64_t{0}; }

  double constant() const { return std::bit_cast<double>(bits_ << 32U); }
  double slope() const { return std::bit_cast<double>(bits_ & high_bits); }
  double at(double square) const { return constant() + slope() * square; }

 private:
  static constexpr std::uint64_t low_one = std::uint64_t{1} << 32U, high_bits = ~(low_one - 1);
  std::uint64_t bits_;
};

/// A point as insertion uses it.
struct alignas(32) InsertedPoint {
  double x, y, z;
  std::uint32_t last_insertion = 0;  ///< in whose cavity's boundary it was last
  std::uint32_t local = 0;           ///< its number there
};

}  // namespace rbpa::space
