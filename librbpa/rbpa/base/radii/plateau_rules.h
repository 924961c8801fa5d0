// What:   the common rules for plateaus of the plane and of space: the least length, the test for structure, and the
//         ranking.
// Source: docs/explanation/filtration_and_persistence.md, sections 6 and 7.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace rbpa::plateau_rules {

inline constexpr double least_ratio = 1.25;      // least ratio to / from of a plateau, except the longest one
inline constexpr std::size_t most_plateaus = 8;  // maximum number of plateaus
inline constexpr double least_share = 0.5;       // least share of covered points at the begin of a plateau

/// Returns whether a shape has several parts, or holes, of significant size. `hole_share` is the share of the holes in
/// the size of the shape.
inline bool is_structured(double effective_parts, double hole_share) {
  constexpr double one_part = 1.1;  // a part with 95 of 100 points has 1.1 effective parts
  constexpr double small_holes = 0.05;
  return effective_parts >= one_part || hole_share >= small_holes;
}

struct Weight {
  bool is_structured;
  double covered;  ///< share of the points that are covered
};

/// Sorts plateaus, the best first. Let F be the long unstructured plateau with the least `from`, at which the points
/// form one piece. The groups are, in order: the long structured plateaus below F; F and the long structured plateaus
/// above F; the other long plateaus, and short ones that cover nine tenths of the points; all others. Each group is
/// sorted by (ratio − 1) · covered, descending.
/// Requires: weight_of(plateau) returns a Weight; Plateau has `from`, `ratio` and `is_long`.
template <typename Plateau, typename WeightOf>
void rank(std::vector<Plateau>& plateaus, const WeightOf& weight_of) {
  constexpr double most = 0.9;  // share of the points
  double piece = std::numeric_limits<double>::infinity();
  for (const Plateau& p : plateaus)
    if (p.is_long && !weight_of(p).is_structured) piece = std::min(piece, p.from);
  const auto key = [&](const Plateau& p) {
    const Weight weight = weight_of(p);
    const int tier = !p.is_long ? 2 : weight.is_structured ? (p.from < piece ? 0 : 1) : (p.from == piece ? 1 : 2);
    return std::tuple(tier, !p.is_long && weight.covered < most, -(p.ratio - 1) * weight.covered, p.from);
  };
  std::sort(plateaus.begin(), plateaus.end(), [&](const Plateau& a, const Plateau& b) { return key(a) < key(b); });
}

}  // namespace rbpa::plateau_rules
