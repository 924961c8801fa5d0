#include "rbpa/solid_plateaus.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/plateau_rules.h"
#include "rbpa/base/steps.h"
#include "rbpa/base/still_ranges.h"
#include "rbpa/space/full/check_triangulation.h"
#include "rbpa/space/persistence/sorted_by_alpha.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/void_tree.h"

namespace rbpa {
namespace {

using Wide = long double;  // for its exponents: volumes are products of coordinates
constexpr double settles = 2;

/// A ratio that noise does not reach: see docs/which_alpha.md for how it was measured.
double noise_ratio(std::size_t distinct) { return 1.5 + 10 / std::sqrt(static_cast<double>(distinct)); }

/// Half the diagonal of the box of the points.
double reach_of(std::span<const Point3> points) {
  Point3 low = points[0], high = low;
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto diagonal = space::from<Wide>(low, high);
  return static_cast<double>(std::sqrt(dot(diagonal, diagonal)) / 2);
}

/// The complex from one radius to the next.
struct State {
  double alpha;
  Wide change;
  std::size_t tetrahedra, components, covered;
  Wide volume;
  double effective_parts, void_share;
};

/// Components of the tetrahedra so far, connected through points, by their numbers of points.
class Parts {
 public:
  explicit Parts(std::size_t of_all) : sets_(of_all), size_(of_all, 0) {}

  void add(const std::array<std::uint32_t, 4>& corners) {
    for (const std::uint32_t corner : corners)
      if (size_[sets_.find(corner)] == 0) {
        size_[corner] = 1;
        count(1, 1);
      }
    for (std::size_t k = 1; k < 4; ++k) {
      const std::uint32_t a = sets_.find(corners[0]), b = sets_.find(corners[k]);
      if (a == b) continue;
      const std::uint32_t both = size_[a] + size_[b];
      count(size_[a], -1);
      count(size_[b], -1);
      count(both, 1);
      size_[sets_.link(a, b)] = both;
    }
  }

  std::size_t components = 0, points = 0;
  std::uint64_t squares = 0;

 private:
  void count(std::uint64_t size, int by) {
    const auto times = static_cast<std::uint64_t>(by);  // modulo 2⁶⁴, as sums are
    components += times;
    points += times * size;
    squares += times * size * size;
  }

  meshops::DisjointSets sets_;
  std::vector<std::uint32_t> size_;  // of each set, at its least point
};

/// Of each tetrahedron, the radius from which on it is in the complex or in a void of it.
std::vector<double> enclosed_from(std::span<const double> radii, const VoidTree& tree) {
  std::vector<double> outermost(tree.nodes.size());  // the closing of the first void that each is parted from
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
    outermost[n] = tree.nodes[n].parent == VoidTree::none ? tree.nodes[n].closes : outermost[tree.nodes[n].parent];
  std::vector<double> from(radii.begin(), radii.end());
  for (std::size_t t = 0; t < from.size(); ++t)
    if (tree.node_of[t] != VoidTree::none) from[t] = outermost[tree.node_of[t]];
  return from;
}

std::vector<State> states_of(std::span<const Point3> points, const Solid& delaunay, std::span<const double> alpha,
                             const VoidTree& tree, Steps& step) {
  std::vector<Wide> volumes(alpha.size());
  for (std::size_t t = 0; t < volumes.size(); ++t) {
    step();
    volumes[t] = space::volume<Wide>(points, delaunay.simplices[t]);
  }
  const std::vector<double> from = enclosed_from(alpha, tree);
  const auto order = space::sorted_by_alpha<Wide>(alpha, volumes, step),
             by_enclosing = space::sorted_by_alpha<Wide>(from, volumes, step);
  // The volume of a flat tetrahedron may round to 0.
  const auto positive = [](Wide v) { return std::max(v, std::numeric_limits<Wide>::min()); };
  Wide whole = 0;
  for (const std::uint32_t t : by_enclosing) whole += volumes[t];
  Parts parts(points.size());
  std::uint64_t most_squares = 0;
  Wide solid = 0, enclosed = 0, turns = 1, filled_before = 1;
  std::vector<State> states;
  for (std::size_t i = 0, next = 0; i < order.size();) {
    const double now = alpha[order[i]];
    for (; i < order.size() && alpha[order[i]] == now; ++i) {
      step(2);
      solid += volumes[order[i]];
      parts.add(delaunay.simplices[order[i]]);
    }
    for (; next < by_enclosing.size() && from[by_enclosing[next]] <= now; ++next)
      enclosed += volumes[by_enclosing[next]];
    most_squares = std::max(most_squares, parts.squares);
    const Wide filled = std::min(Wide(1), positive(solid) / positive(enclosed));
    turns *= std::max(filled / filled_before, filled_before / filled);
    filled_before = filled;
    const auto of_parts = static_cast<double>(parts.points);
    states.push_back(
        {now, static_cast<Wide>(most_squares) * turns * std::pow(positive(enclosed) / positive(whole), Wide(1) / 12), i,
         parts.components, parts.points, solid, of_parts * of_parts / static_cast<double>(parts.squares),
         static_cast<double>(1 - filled)});
  }
  return states;
}

SolidPlateau plateau_of(const StepRange& range, const std::vector<State>& states, double ratio, std::size_t distinct) {
  SolidPlateau plateau{.from = states[range.first].alpha, .ratio = ratio};
  if (range.last < states.size()) plateau.to = states[range.last].alpha;
  plateau.alpha = plateau.from * std::min(std::sqrt(ratio), settles);
  const auto after = std::upper_bound(states.begin(), states.end(), plateau.alpha,
                                      [](double alpha, const State& state) { return alpha < state.alpha; });
  const State& there = *(after - 1);
  plateau.tetrahedra = there.tetrahedra;
  plateau.components = there.components;
  plateau.covered = there.covered;
  plateau.volume = static_cast<double>(there.volume);
  plateau.effective_parts = there.effective_parts;
  plateau.void_share = there.void_share;
  plateau.is_structured = plateau_rules::is_structured(there.effective_parts, there.void_share);
  plateau.is_long = ratio >= noise_ratio(distinct);
  return plateau;
}

}  // namespace

std::vector<SolidPlateau> solid_plateaus(std::span<const Point3> points, const Solid& delaunay,
                                         std::span<const double> radii, const std::function<bool()>& go_on) {
  space::check_triangulation("solid_plateaus", points, delaunay, radii);
  if (radii.empty()) return {};
  Steps step(go_on);
  const std::vector<State> states =
      states_of(points, delaunay, radii, void_tree(points, delaunay, radii, VoidWalls::solid, 1, go_on), step);
  std::vector<double> alpha;
  std::vector<long double> change;
  for (const State& state : states) {
    alpha.push_back(state.alpha);
    change.push_back(state.change);
  }
  const std::size_t distinct = delaunay.distinct;
  const auto begin = std::find_if(states.begin(), states.end(), [&](const State& state) {
    return static_cast<double>(state.covered) / static_cast<double>(distinct) >= plateau_rules::least_share;
  });
  const StepRange all{static_cast<std::size_t>(begin - states.begin()), states.size()};
  const StillRanges ranges(alpha, std::move(change), reach_of(points));
  std::vector<SolidPlateau> found;
  for (const StepRange& range : ranges.longest(all, plateau_rules::most_plateaus, plateau_rules::least_ratio))
    found.push_back(plateau_of(range, states, ranges.ratio_of(range), distinct));
  plateau_rules::rank(found, [&](const SolidPlateau& p) {
    return plateau_rules::Weight{p.is_structured, static_cast<double>(p.covered) / static_cast<double>(distinct)};
  });
  return found;
}

}  // namespace rbpa
