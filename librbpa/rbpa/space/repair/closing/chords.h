// What: scales the rim of a hole so that no computation with it underflows or overflows, and chooses the chords of the
//       rim that its triangulation may use. The sides of the rim count as chords.
// Why:  a rim of n corners has n²/2 chords, and n³/6 triangles on them. For a long rim, the nearest chords on several
//       levels suffice: between all corners, between every second corner, every fourth, and so on, so that wide parts
//       get long chords.
// Law:  a function of the places of the corners and of the corner at which the rim begins.
// Cost: n log n unless the spacing of corners varies much along the rim, n² at most; some tens of chords a corner.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/cells/box_scale.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

using Vector = Vector3<double>;

inline Vector operator-(const Vector& u, const Vector& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }

/// The greatest turn of a surface over an edge. The turn is |n − n'|² for the unit normals n and n' on both sides: 0
/// where the surface is flat, 4 where it is folded back, ascending with the angle. Angles below 0.0035 degrees count as
/// flat. The code uses no function that processors or libraries may round differently.
inline constexpr float most_turn = 4;
inline float turn_between(const Vector& unit, const Vector& other) {
  constexpr double flat = 0x1p-28;
  const Vector d = unit - other;
  const double turn = dot(d, d);
  return turn < flat ? 0 : turn < 4 ? static_cast<float>(turn) : most_turn;
}

/// The rim of a hole, with the hole to its left. No two corners are at one point.
struct Rim {
  std::vector<Point3> points;
  std::vector<Vector> places;  ///< the points, scaled to a box of side 1
  /// Unit normal of the triangle at the edge from each corner to the next; 0 if the triangle has no area.
  std::vector<Vector> normals;
  int exponent = 0;  ///< one unit of `places` is 2^exponent units of `points`

  /// Scales the corners. `across` has, for each edge, the third corner of the triangle at that edge.
  Rim(std::span<const Point3> corners, std::span<const Point3> across) : points(corners.begin(), corners.end()) {
    Box box;
    for (const Point3& p : corners) box.include(p);
    for (const Point3& p : across) box.include(p);
    const BoxScale scale(box.low, box.high);
    exponent = scale.exponent();
    for (const Point3& p : points) places.push_back(scale.place(p));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector &from = places[i], &to = places[(i + 1) % points.size()];
      const Vector n = cross(from - to, scale.place(across[i]) - to);
      const double length = std::sqrt(dot(n, n));
      normals.push_back(length > 0 ? Vector{n.x / length, n.y / length, n.z / length} : Vector{0, 0, 0});
    }
  }

  std::size_t size() const { return points.size(); }
};

/// A chord between corners low < high of a rim.
using Chord = std::pair<std::uint32_t, std::uint32_t>;

/// Returns all candidate chords and the sides of the rim, sorted. Throws: Cancelled.
std::vector<Chord> candidate_chords(const Rim& rim, meshops::Steps& step);

/// Chords, numbered in ascending order of the low end, then of the high end.
class Chords {
 public:
  /// Takes the candidates of a rim of `corners` corners, except the forbidden chords. Requires: both are sorted.
  Chords(std::size_t corners, std::vector<Chord> candidates, std::span<const Chord> forbidden);

  std::size_t size() const { return chords_.size(); }
  const Chord& operator[](std::size_t number) const { return chords_[number]; }
  /// Returns whether every chord of the rim that is not forbidden is among the chords. is_complete() returns whether
  /// every chord of the rim is.
  bool are_all() const { return all_; }
  bool is_complete() const { return chords_.size() == (first_to_.size() - 1) * (first_to_.size() - 2) / 2; }
  /// Returns the number of the first chord with the low end `corner`; for the corner after the last, the number of
  /// chords.
  std::uint32_t first_from(std::uint32_t corner) const { return first_from_[corner]; }
  /// Returns the first place of the chords with the high end `corner`, in the order by high, then low end.
  std::uint32_t first_to(std::uint32_t corner) const { return first_to_[corner]; }
  /// Returns the place of a chord in the order of the high end, then of the low end. number_at() is the inverse.
  std::uint32_t place_to(std::size_t number) const { return place_to_[number]; }
  std::uint32_t number_at(std::size_t place) const { return numbers_[place]; }
  /// Returns the high end of each chord, by its number. lows() returns the low end of each chord, by its place.
  const std::vector<std::uint32_t>& highs() const { return highs_; }
  const std::vector<std::uint32_t>& lows() const { return lows_; }
  /// Returns the number of a chord. Requires: the chord is among the chords.
  std::uint32_t number_of(const Chord& chord) const;

 private:
  bool all_;
  std::vector<Chord> chords_;
  std::vector<std::uint32_t> first_from_, first_to_, place_to_, numbers_, highs_, lows_;
};

}  // namespace rbpa::space
