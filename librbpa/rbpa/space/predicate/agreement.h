// What: tests whether a triangle agrees with the normals at its corners: whether the triangle's normal has a positive
//       scalar product with every normal at a corner.
// Law:  exact. If several points are at a corner, the normals of all these points count.
// Cost: some nanoseconds for points that fit double; otherwise one TriangleNormal::sign_along() for each normal.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/duplicate.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/normal_sign.h"

namespace rbpa::space {

/// A test of oriented triangles with an area. A place is a distinct point; corners are indices of places.
class Agreement {
 public:
  /// The normal of a point that repeats the point of a place.
  struct Further {
    std::uint32_t place;
    Point3 normal;
  };

  /// Keeps the spans. Without normals, every triangle agrees. Requires: no normals, or one for each place; if
  /// `fits_double`, the places fit double (cells/scale.h).
  Agreement(std::span<const Point3> places, std::span<const Point3> normals, std::vector<Further> further,
            bool fits_double)
      : places_(places), normals_(normals), further_(std::move(further)), fits_double_(fits_double) {
    std::sort(further_.begin(), further_.end(),
              // The order within one place does not matter.
              [](const Further& a, const Further& b) { return a.place < b.place; });
  }

  /// Makes a test of triangles whose corners are input indices. Requires: `duplicates` are the duplicates of `points`.
  Agreement(std::span<const Point3> points, std::span<const Point3> normals, std::span<const Duplicate> duplicates)
      : Agreement(points, normals, further_of(normals, duplicates), false) {}

  /// Returns whether the triangle (a, b, c) agrees with all normals at its corners.
  bool operator()(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (normals_.empty()) return true;
    if (fits_double_ && further_.empty()) {
      const RoundedNormal<double> normal(places_[a], places_[b], places_[c]);
      int certain = 0;
      for (const std::uint32_t corner : {a, b, c}) {
        const int sign = sign_along(normal, normals_[corner]);
        if (sign < 0) return false;
        certain += sign;
      }
      if (certain == 3) return true;
    }
    const TriangleNormal normal(places_[a], places_[b], places_[c]);
    return !disagrees_at(a, normal) && !disagrees_at(b, normal) && !disagrees_at(c, normal);
  }

  /// Returns for each corner whether the triangle disagrees with a normal at the corner.
  std::array<bool, 3> disagreeing(const std::array<std::uint32_t, 3>& triangle) const {
    const auto [a, b, c] = triangle;
    if (normals_.empty()) return {false, false, false};
    const TriangleNormal normal(places_[a], places_[b], places_[c]);
    return {disagrees_at(a, normal), disagrees_at(b, normal), disagrees_at(c, normal)};
  }

  /// Returns false only if no triangle (v, x, y) agrees for which x follows y in the cyclic sequence `cycle` of places.
  bool may_agree(std::uint32_t v, std::span<const std::uint32_t> cycle) const {
    if (!fits_double_ || normals_.empty()) return true;
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      const std::uint32_t x = cycle[k], y = cycle[k == 0 ? cycle.size() - 1 : k - 1];
      if (sign_along({places_[v], places_[x], places_[y]}, normals_[v]) >= 0) return true;
    }
    return false;
  }

 private:
  /// Returns the sign of the scalar product of a triangle's normal and v; 0 if the sign is not certain. Requires: the
  /// triangle's corners fit double.
  static int sign_along(const RoundedNormal<double>& normal, const Point3& v) {
    const double product = normal.product(v), bound = 0x1p-50 * normal.magnitude(v);
    if (!(bound > 0x1p-900)) return 0;  // terms may have underflowed
    return product > bound ? 1 : product < -bound ? -1 : 0;
  }

  static std::vector<Further> further_of(std::span<const Point3> normals, std::span<const Duplicate> duplicates) {
    std::vector<Further> further;
    if (!normals.empty())
      for (const Duplicate& d : duplicates) further.push_back({d.stands_for, normals[d.index]});
    return further;
  }

  bool disagrees_at(std::uint32_t corner, const TriangleNormal& normal) const {
    if (normal.sign_along(normals_[corner]) <= 0) return true;
    auto other = std::lower_bound(further_.begin(), further_.end(), corner,
                                  [](const Further& f, std::uint32_t place) { return f.place < place; });
    for (; other != further_.end() && other->place == corner; ++other)
      if (normal.sign_along(other->normal) <= 0) return true;
    return false;
  }

  std::span<const Point3> places_, normals_;
  std::vector<Further> further_;  // normals of repeated points, sorted by place
  bool fits_double_;
};

}  // namespace rbpa::space
