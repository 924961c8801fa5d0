// What: decides exactly which of a few points of a tile a ball that rolls over a→b to the left touches first.
// Why:  bounds in single precision sometimes leave two or more candidates, and on a lattice a tie for each point.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rbpa/plane/predicate/chord.h"
#include "rbpa/plane/tile/coordinates.h"
#include "rbpa/plane/tile/tile.h"

namespace rbpa {

class ExactApex {
 public:
  using Index = std::uint16_t;

  /// Keeps references to both arguments.
  ExactApex(const Tile& tile, const TileCoordinates& coordinates) : tile_(tile), at_(coordinates) {}

  /// Returns the candidate that the ball touches first. Candidates may lie on either side of the chord; returns `none`
  /// if no candidate lies left of the chord.
  Index winner(std::size_t a, std::size_t b, std::span<const Index> candidates, Index none) const {
    const Chord<double> chord(tile_.points[a], tile_.points[b]);
    Index best = none;
    Chord<double>::Candidate least{};
    for (const Index i : candidates) {
      const Chord<double>::Candidate candidate = chord.candidate(tile_.points[i]);
      if (!chord.is_left(candidate) || (best != none && !chord.is_inside(candidate, least))) continue;
      best = i;
      least = candidate;
    }
    return best;
  }

  /// Returns the candidate that the ball touches first.
  /// Requires: at least one candidate; all left of the chord; a, b and candidates in a box of at most `lattice_extent`.
  Index winner_on_lattice(std::size_t a, std::size_t b, std::span<const Index> candidates) const {
    Index best = candidates[0];
    for (const Index i : candidates.subspan(1))
      if (beats_on_lattice(a, b, i, best)) best = i;
    return best;
  }

 private:
  /// Returns whether p is in the circle of a, b, q; the symbolic perturbation breaks ties. Products of four differences
  /// are exact in double.
  bool beats_on_lattice(std::size_t a, std::size_t b, std::size_t p, std::size_t q) const {
    struct Ratio {
      double dot, cross;
    };
    const auto center = [&](std::size_t i) -> Ratio {
      const double ex = double(at_.x[i]) - at_.x[a], ey = double(at_.y[i]) - at_.y[a];
      const double dx = double(at_.x[b]) - at_.x[a], dy = double(at_.y[b]) - at_.y[a];
      return {ex * (double(at_.x[i]) - at_.x[b]) + ey * (double(at_.y[i]) - at_.y[b]), dx * ey - dy * ex};
    };
    const Ratio of_p = center(p), of_q = center(q);
    const double first = of_p.dot * of_q.cross, second = of_q.dot * of_p.cross;
    return first < second || (first == second && wins_tie_on_lattice(a, b, p, q));
  }

  /// Returns whether P::perturbed_side(a, b, q, p) > 0 for p and q left of a→b, without a branch: a lattice has a tie
  /// for each point. The largest of the four points on the circle decides.
  bool wins_tie_on_lattice(std::size_t a, std::size_t b, std::size_t p, std::size_t q) const {
    const auto order = [&](std::size_t i) { return double(at_.x[i]) * 0x1p27 + at_.y[i]; };  // exact, lexicographic
    const double a_order = order(a), b_order = order(b), p_order = order(p), q_order = order(q);
    const double qx = double(at_.x[q]) - at_.x[b], qy = double(at_.y[q]) - at_.y[b];
    const double px = double(at_.x[p]) - at_.x[b], py = double(at_.y[p]) - at_.y[b];
    const bool p_is_behind_q = qx * py - qy * px > 0;  // from b on around the circle
    const bool end_decides = std::max(a_order, b_order) > std::max(p_order, q_order);
    const bool by_end = p_is_behind_q == (a_order > b_order), by_apex = q_order > p_order;
    return (end_decides & by_end) | (!end_decides & by_apex);
  }

  const Tile& tile_;
  const TileCoordinates& at_;
};

}  // namespace rbpa
