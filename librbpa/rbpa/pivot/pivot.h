// What:   the pivot: which point does a ball that rolls over the edge a→b to its left touch first?
// Law:    a function of the points alone: the Delaunay apex of a Delaunay edge, if its circumradius is ≤ alpha. Hints
//         and the layout of the cells change the time it takes and nothing else.
// Cost:   constant on average for bounded variation of density; the search goes from near to far and ends with the
//         best candidate's circle. See docs/pivot.md.
// Source: Restricted BPA, sections 3.1 and 3.2.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>

#include "rbpa/pivot/candidate.h"
#include "rbpa/predicate/radius.h"
#include "rbpa/search/convex_hull.h"
#include "rbpa/search/point_grid.h"

namespace rbpa {

template <typename Real>
class Pivot {
 public:
  using Site = std::uint32_t;

  /// Keeps references. `grid_unit` as for Candidates. Requires for an infinite radius: the points are not on a line.
  Pivot(const PointGrid<Real>& grid, Radius radius, Real grid_unit)
      : grid_(grid), radius_(radius), grid_unit_(grid_unit) {
    if (radius.is_infinite()) hull_.emplace(grid.points());
  }

  /// The apex left of the Delaunay edge a→b, or nothing when no ball of at most the radius reaches one.
  /// `hints` are sites that may well be it, and are considered first: they cost little and spare a search.
  std::optional<Site> operator()(Site a, Site b, std::initializer_list<Site> hints = {}) const {
    Candidates<Real> candidates(grid_.points().data(), a, b, grid_unit_);
    for (const Site hint : hints) candidates.expect(hint);
    search(candidates);
    const auto apex = candidates.best();
    if (!apex || !radius_.admits<Real>(candidates.a(), candidates.b(), grid_.points()[*apex])) return std::nullopt;
    return apex;
  }

 private:
  static constexpr Real infinity = std::numeric_limits<Real>::infinity();

  void search(Candidates<Real>& candidates) const {
    const Real chord = std::sqrt(Predicates<Real>::dot(candidates.chord(), candidates.chord()));
    Real reach =
        std::min(std::max(first_reach_in_chords * chord, first_reach_in_cells * grid_.cell_size_at(candidates.a())),
                 most_first_reach_in_chords * chord);
    Real searched = std::min(centre_for(chord, reach), candidates.centre_bound());
    const bool reaches_ball = !radius_.is_infinite() && reach >= Real(radius_.value());
    if (reaches_ball) searched = std::min(searched, farthest(chord));
    int empty_looks = 0;
    for (;;) {
      grid_.scan(Region<Real>::segment(candidates.a(), candidates.b(), chord, searched),
                 [&](Site first, Site last) { candidates.consider(first, last); });
      candidates.settle();
      Real next = candidates.centre_bound();
      if (next <= searched) return;
      const Real end = farthest(chord);
      if (searched >= end) return;
      if (next == infinity) {
        // Without a radius the search for what is not there would go through all that lies along the hull.
        if (empty_looks == 0 && hull_ && hull_->has_edge(candidates.site_a(), candidates.site_b())) return;
        reach *= 2;
        // A cluster was left behind: on to the scale at which it is one of many points, whatever lies between.
        if (++empty_looks == looks_in_chords) reach = std::max(reach, first_reach_in_cells * grid_.cell_size());
        next = centre_for(chord, reach);
      }
      searched = std::min(next, end);
    }
  }

  /// centre_for() the ball itself: nothing beyond is in its reach.
  Real farthest(Real chord) const {
    return radius_.is_infinite() ? infinity : centre_for(chord, Real(radius_.value()) * inflated);
  }

  /// How many half-chords left of the chord's midpoint the centre of a circle of this radius lies, rounded up;
  /// infinity for a circle that no point of the input can tell from the whole half-plane.
  Real centre_for(Real chord, Real radius) const {
    if (!(radius < 4 * grid_.diameter_bound())) return infinity;
    const Real ratio = 2 * radius / chord;
    return std::sqrt(std::max(Real(0), ratio * ratio - 1)) * inflated;
  }

  static constexpr Real inflated = 1 + 64 * Predicates<Real>::unit;
  // Measured: a first look this far finds the apex in most cases and wastes few candidates on uniform points.
  static constexpr Real first_reach_in_chords = Real(0.6);
  static constexpr Real first_reach_in_cells = Real(0.75);
  // In a cluster the coarsest cells say nothing: there the chord is the scale.
  static constexpr Real most_first_reach_in_chords = Real(4);
  static constexpr int looks_in_chords = 6;

  const PointGrid<Real>& grid_;
  Radius radius_;
  Real grid_unit_;
  std::optional<ConvexHull<Real>> hull_;
};

}  // namespace rbpa
