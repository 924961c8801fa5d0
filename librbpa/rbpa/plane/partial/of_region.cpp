// partial(): reads each triangle of a region once, and then its boundary and rim only.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "meshops/core/fresh_vector.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/triangle.h"
#include "rbpa/plane/partial.h"
#include "rbpa/plane/partial/region_complex.h"
#include "rbpa/plane/partial/rings.h"
#include "rbpa/plane/partial/state.h"

namespace rbpa {
namespace {

constexpr unsigned all = 7;  // bits of corners that are owned

/// Calls `checkpoint` at every 65,536th step. Throws: Cancelled, from `checkpoint`.
void check_at(std::size_t step, const Checkpoint& checkpoint) {
  if (checkpoint && step % 65536 == 0) checkpoint();
}

/// A side without a neighbor, of triangle `triangle` across from its corner `across`.
struct OpenSide {
  std::uint32_t triangle;
  std::uint32_t across;
};

/// A walk along the boundary sides of a region's triangles, as far as the region determines the next side.
class RimWalk {
 public:
  explicit RimWalk(const RegionComplex& of) : of_(of), seen_(of.triangulation().triangles.size(), 0) {}

  std::uint32_t from(const OpenSide& side) const { return corner(side.triangle, side.across + 1); }
  std::uint32_t to(const OpenSide& side) const { return corner(side.triangle, side.across + 2); }

  bool is_new(const OpenSide& side) const { return (unsigned{seen_[side.triangle]} >> side.across & 1U) == 0; }

  /// Returns the points from the beginning of a new side on, triangles on the left: up to the first point that the
  /// region does not own, or each point of a closed curve once.
  std::vector<Corner> path_from(OpenSide side) {
    std::vector<Corner> path{of_.corner(from(side))};
    const OpenSide first = side;
    do {
      seen_[side.triangle] = static_cast<std::uint8_t>(seen_[side.triangle] | 1U << side.across);
      path.push_back(of_.corner(to(side)));
      if (!of_.owns(to(side))) return path;
      side = side_after(side);
    } while (side.triangle != first.triangle || side.across != first.across);
    path.pop_back();  // the last point repeats the first
    return path;
  }

 private:
  std::uint32_t corner(std::uint32_t t, std::uint32_t k) const { return of_.triangulation().triangles[t][k % 3]; }

  /// Returns the boundary side that begins where `side` ends, at the other end of the fan around that point.
  OpenSide side_after(const OpenSide& side) const {
    const std::uint32_t pivot = to(side);
    OpenSide at{side.triangle, (side.across + 1) % 3};
    for (std::uint32_t next = across(at); next != AlphaComplex::none; next = across(at)) {
      const auto& corners = of_.triangulation().triangles[next];
      const std::uint32_t place = corners[0] == pivot ? 0 : corners[1] == pivot ? 1 : 2;
      at = {next, (place + 2) % 3};
    }
    return at;
  }
  std::uint32_t across(const OpenSide& side) const { return of_.triangulation().neighbors[side.triangle][side.across]; }

  const RegionComplex& of_;
  std::vector<std::uint8_t> seen_;  // for each triangle, a bit for each side
};

/// The result of one pass over the triangles.
struct Pass {
  explicit Pass(const RegionComplex& of)
      : components(of.triangulation().triangles.size()), triangle_at(of.points(), no_index) {}

  std::uint64_t triangles = 0;
  std::uint64_t twice_edges = 0;
  meshops::DisjointSets components;        // sets of triangles, joined across sides with an owned end
  std::vector<std::uint32_t> triangle_at;  // for each owned point, a triangle at the point, or no_index
  std::vector<std::uint32_t> shared;       // triangles with both owned and other corners
  std::vector<OpenSide> boundary;          // sides that have an owned end
};

/// Adds to `pass` the sides of triangle t that have an owned end: the region knows both triangles at each of these
/// sides. The region counts the sides whose lesser end it owns.
void look_at_sides(const RegionComplex& of, std::uint32_t t, unsigned owned, Pass& pass) {
  const auto& corners = of.triangulation().triangles[t];
  const auto& neighbors = of.triangulation().neighbors[t];
  for (std::uint32_t k = 0; k < 3; ++k) {
    if ((owned & ~(1U << k)) == 0) continue;
    const std::uint32_t other = neighbors[k];
    const bool counts = owned == all || of.owns_edge(corners[(k + 1) % 3], corners[(k + 2) % 3]);
    if (other == no_index) {
      pass.boundary.push_back({t, k});
      pass.twice_edges += counts ? 2 : 0;
    } else {
      if (other < t) pass.components.unite(t, other);
      pass.twice_edges += counts ? 1 : 0;
    }
  }
}

Pass look_at_triangles(const RegionComplex& of, const Checkpoint& checkpoint) {
  Pass pass(of);
  const auto& triangles = of.triangulation().triangles;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    check_at(t, checkpoint);
    const unsigned owned = of.owned_corners(t);
    if (owned == 0) continue;
    pass.triangles += std::uint64_t{of.owns_triangle(t, owned)};
    for (std::size_t k = 0; k < 3; ++k)
      if ((owned >> k & 1U) != 0) pass.triangle_at[triangles[t][k]] = t;
    if (owned != all) pass.shared.push_back(t);
    look_at_sides(of, t, owned, pass);
  }
  return pass;
}

/// A builder of the state from the result of a pass.
class Builder {
 public:
  Builder(const RegionComplex& of, Pass&& pass, const Checkpoint& checkpoint)
      : of_(of), pass_(std::move(pass)), checkpoint_(checkpoint) {}

  PartialState build() {
    number_components();
    add_shared();
    add_pinches();  // to be called before the points are added
    add_points();
    add_boundary();
    return std::move(state_);
  }

 private:
  /// Returns the component of a triangle with an owned corner.
  std::uint32_t component(std::uint32_t t) const { return number_[t]; }

  void number_components() {
    const std::size_t triangles = of_.triangulation().triangles.size();
    number_.resize(triangles);
    std::uint32_t count = 0;
    for (std::uint32_t t = 0; t < triangles; ++t) {
      check_at(t, checkpoint_);
      if (of_.owned_corners(t) == 0) continue;
      const std::uint32_t least = pass_.components.find(t);
      number_[t] = least == t ? count++ : number_[least];
    }
    state_.open.resize(count);
    for (std::uint32_t c = 0; c < count; ++c) state_.open[c].group = c;
  }

  void add_shared() {
    for (const std::uint32_t t : pass_.shared) {
      const auto& [a, b, c] = of_.triangulation().triangles[t];
      const unsigned owned = of_.owned_corners(t);
      state_.shared.push_back({.corners = {of_.index(a), of_.index(b), of_.index(c)},
                               .component = component(t),
                               .owned = (owned & 1U) + (owned >> 1U & 1U) + (owned >> 2U & 1U)});
    }
  }

  /// Adds the owned points at which several components touch.
  void add_pinches() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> fans;  // point, component
    for (const OpenSide& side : pass_.boundary) {
      const std::uint32_t from = of_.triangulation().triangles[side.triangle][(side.across + 1) % 3];
      if (of_.owns(from)) fans.emplace_back(from, component(side.triangle));
    }
    sort_unique(fans);
    meshops::DisjointSets groups(state_.open.size());
    for (std::size_t i = 0; i + 1 < fans.size();) {
      const auto [at, first] = fans[i];
      std::size_t end = i + 1;
      for (; end < fans.size() && fans[end].first == at; ++end) groups.unite(first, fans[end].second);
      if (end - i > 1) {
        Pinch& pinch = state_.pinches.emplace_back();
        for (; i < end; ++i) pinch.members.push_back(fans[i].second);
        pinch.points = 1;
        pinched_.push_back(at);
        pass_.triangle_at[at] = no_index;  // the point counts in the pinch
      }
      i = end;
    }
    for (OpenComponent& component : state_.open) component.group = groups.find(component.group);
  }

  void add_points() {
    const AlphaComplex& triangulation = of_.triangulation();
    PartialCounts& counts = state_.counts;
    for (std::uint32_t i = 0; i < of_.points(); ++i) {
      counts.points += std::uint64_t{of_.owns(i)};
      if (const std::uint32_t t = pass_.triangle_at[i]; t != no_index) ++state_.open[component(t)].points;
    }
    for (const std::uint32_t i : triangulation.isolated) counts.isolated += std::uint64_t{of_.owns(i)};
    for (const Duplicate& duplicate : triangulation.duplicates)
      if (of_.owns(duplicate.index)) add_duplicate(duplicate.stands_for);
    counts.vertices = counts.points - counts.duplicates - counts.isolated;
    counts.triangles = pass_.triangles;
    counts.edges = pass_.twice_edges / 2;
  }

  /// Adds a duplicate of point `of` to the component or the pinch of that point, if there is one.
  void add_duplicate(std::uint32_t of) {
    ++state_.counts.duplicates;
    if (const std::uint32_t t = pass_.triangle_at[of]; t != no_index) {
      ++state_.open[component(t)].points;
      return;
    }
    const auto pinch = std::lower_bound(pinched_.begin(), pinched_.end(), of);
    if (pinch != pinched_.end() && *pinch == of)
      ++state_.pinches[static_cast<std::size_t>(pinch - pinched_.begin())].points;
  }

  void add_boundary() {
    RimWalk walk(of_);
    std::size_t steps = 0;
    for (const OpenSide& side : pass_.boundary) {
      if (of_.owns(walk.from(side)) || !walk.is_new(side)) continue;
      const std::uint32_t c = component(side.triangle);
      Chain& chain = state_.chains.emplace_back(Chain{c, walk.path_from(side)});
      for (const Corner& corner : chain.path) state_.open[c].least = std::min(state_.open[c].least, corner.at);
    }
    // Sides that begin at an owned point and are in no chain are on closed curves.
    for (const OpenSide& side : pass_.boundary) {
      check_at(++steps, checkpoint_);
      if (!walk.is_new(side)) continue;
      add_curve(state_.open[component(side.triangle)], walk.path_from(side));
      ++state_.counts.boundary_curves;
    }
  }

  const RegionComplex& of_;
  Pass pass_;
  const Checkpoint& checkpoint_;
  meshops::FreshVector<std::uint32_t> number_;  // for each triangle, its component
  std::vector<std::uint32_t> pinched_;          // the points of pinches, ascending
  PartialState state_;
};

Partial partial_of(const RegionComplex& complex, const Region& region, double alpha, const PartialOptions& options) {
  const AlphaComplex& triangulation = complex.triangulation();
  const Checkpoint checkpoint = checkpoint_of(options.progress, triangulation.distinct, triangulation.triangles.size());
  PartialState state = Builder(complex, look_at_triangles(complex, checkpoint), checkpoint).build();
  state.alpha = alpha;
  state.cover = Cover(region);
  settle(state, checkpoint);
  return Partial(std::move(state));
}

OwnedItems items_of(const RegionComplex& complex) {
  const AlphaComplex& triangulation = complex.triangulation();
  OwnedItems items;
  for (std::uint32_t t = 0; t < triangulation.triangles.size(); ++t) {
    const unsigned owned = complex.owned_corners(t);
    if (owned == 0 || !complex.owns_triangle(t, owned)) continue;
    const auto& [a, b, c] = triangulation.triangles[t];
    items.triangles.push_back({complex.index(a), complex.index(b), complex.index(c)});
  }
  for (const std::uint32_t i : triangulation.isolated)
    if (complex.owns(i)) items.isolated.push_back(complex.index(i));
  return items;
}

}  // namespace

Partial partial(const Region& region, const RegionPoints& points, double alpha, const PartialOptions& options) {
  return partial_of(RegionComplex(region, points, alpha, options), region, alpha, options);
}

PartialAndItems partial_and_items(const Region& region, const RegionPoints& points, double alpha,
                                  const PartialOptions& options) {
  const RegionComplex complex(region, points, alpha, options);
  return {.partial = partial_of(complex, region, alpha, options), .owned = items_of(complex)};
}

}  // namespace rbpa
