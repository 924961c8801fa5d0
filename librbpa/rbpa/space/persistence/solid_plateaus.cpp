#include "rbpa/space/persistence/solid_plateaus.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/radii/cube_root.h"
#include "rbpa/base/radii/plateau_rules.h"
#include "rbpa/base/radii/still_ranges.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/pairing/sorted_by_alpha.h"
#include "rbpa/space/persistence/void_tree.h"
#include "rbpa/space/predicate/bounding_box.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/solid/boundary/check_triangulation.h"

namespace rbpa {
namespace {

using Wide = long double;  // products of three coordinates may exceed double
constexpr double settles = 2;

/// Returns a ratio that noise does not reach (docs/explanation/filtration_and_persistence.md, section 8).
double noise_ratio(std::size_t distinct) { return 1.5 + 10 / std::sqrt(static_cast<double>(distinct)); }

/// Returns half the diagonal of the points' bounding box.
double reach_of(std::span<const Point3> points) {
  const auto [low, high] = space::box_of(points);
  const auto diagonal = space::from<Wide>(low, high);
  return static_cast<double>(std::sqrt(dot(diagonal, diagonal)) / 2);
}

/// The growth of the complex from each radius to the next.
struct Growth {
  std::vector<double> alpha;
  std::vector<Wide> change;
  std::vector<double> volume, void_share;
  std::size_t begin = 0;  // index of the first radius from which on enough points are covered
};

/// The components, connected through points, of all tetrahedra added, with their numbers of points.
class Parts {
 public:
  explicit Parts(std::size_t of_all) : sets_(of_all), size_(of_all, 0) {}

  /// Returns whether all points are in one component. No further tetrahedron then changes the components.
  bool is_whole(std::size_t distinct) const { return components == 1 && points == distinct; }
  double effective() const {
    const auto of_all = static_cast<double>(points);
    return of_all * of_all / static_cast<double>(squares);
  }
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
    const auto times = static_cast<std::uint64_t>(by);  // −1 wraps modulo 2⁶⁴; so do the sums, correctly
    components += times;
    points += times * size;
    squares += times * size * size;
  }

  meshops::DisjointSets sets_;
  std::vector<std::uint32_t> size_;  // size_[i]: number of points in the set with least index i
};

/// Returns for each tetrahedron the radius from which on it is in the complex or in a void of the complex.
std::vector<double> enclosed_from(std::span<const double> radii, const VoidTree& tree) {
  std::vector<double> outermost(tree.nodes.size());  // for each node, the closing radius of the root of its tree
  for (std::size_t n = 0; n < tree.nodes.size(); ++n)
    outermost[n] = tree.nodes[n].parent == VoidTree::none ? tree.nodes[n].closes : outermost[tree.nodes[n].parent];
  std::vector<double> from(radii.begin(), radii.end());
  for (std::size_t t = 0; t < from.size(); ++t)
    if (tree.node_of[t] != VoidTree::none) from[t] = outermost[tree.node_of[t]];
  return from;
}

Growth growth_of(std::span<const Point3> points, const Solid& delaunay, std::span<const double> alpha,
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
  Growth growth;
  for (std::size_t i = 0, next = 0; i < order.size();) {
    const double now = alpha[order[i]];
    for (; i < order.size() && alpha[order[i]] == now; ++i) {
      step(2);
      solid += volumes[order[i]];
      if (!parts.is_whole(delaunay.distinct)) parts.add(delaunay.simplices[order[i]]);
    }
    for (; next < by_enclosing.size() && from[by_enclosing[next]] <= now; ++next)
      enclosed += volumes[by_enclosing[next]];
    most_squares = std::max(most_squares, parts.squares);
    const Wide filled = std::min(Wide(1), positive(solid) / positive(enclosed));
    turns *= std::max(filled / filled_before, filled_before / filled);
    filled_before = filled;
    const Wide twelfth_root = std::sqrt(std::sqrt(cube_root(positive(enclosed) / positive(whole))));
    if (static_cast<double>(parts.points) / static_cast<double>(delaunay.distinct) < plateau_rules::least_share)
      growth.begin = growth.alpha.size() + 1;
    growth.alpha.push_back(now);
    growth.change.push_back(static_cast<Wide>(most_squares) * turns * twelfth_root);
    growth.volume.push_back(static_cast<double>(solid));
    growth.void_share.push_back(static_cast<double>(1 - filled));
  }
  return growth;
}

/// Returns the plateau without the fields that count() fills in.
SolidPlateau plateau_of(const StepRange& range, const Growth& growth, double ratio, std::size_t distinct) {
  SolidPlateau plateau{.from = growth.alpha[range.first], .ratio = ratio};
  if (range.last < growth.alpha.size()) plateau.to = growth.alpha[range.last];
  plateau.alpha = plateau.from * std::min(std::sqrt(ratio), settles);
  const auto after = std::upper_bound(growth.alpha.begin(), growth.alpha.end(), plateau.alpha);
  const auto there = static_cast<std::size_t>(after - growth.alpha.begin()) - 1;
  plateau.volume = growth.volume[there];
  plateau.void_share = growth.void_share[there];
  plateau.is_long = ratio >= noise_ratio(distinct);
  return plateau;
}

void count(std::size_t points, const Solid& delaunay, std::span<const double> radii, Steps& step,
           SolidPlateau& plateau) {
  Parts parts(points);
  for (std::size_t t = 0; t < radii.size(); ++t) {
    if (radii[t] > plateau.alpha) continue;
    step();
    ++plateau.tetrahedra;
    if (!parts.is_whole(delaunay.distinct)) parts.add(delaunay.simplices[t]);
  }
  plateau.components = parts.components;
  plateau.covered = parts.points;
  plateau.effective_parts = parts.effective();
  plateau.is_structured = plateau_rules::is_structured(plateau.effective_parts, plateau.void_share);
}

}  // namespace

std::vector<SolidPlateau> solid_plateaus(std::span<const Point3> points, const Solid& delaunay,
                                         std::span<const double> radii, const GoOn& go_on) {
  space::check_triangulation("solid_plateaus", points, delaunay, radii);
  if (radii.empty()) return {};
  Steps step(go_on);
  const std::size_t distinct = delaunay.distinct;
  Growth growth =
      growth_of(points, delaunay, radii, void_tree(points, delaunay, radii, ComplexKind::solid, 1, go_on), step);
  const StillRanges ranges(growth.alpha, std::move(growth.change), reach_of(points));
  std::vector<SolidPlateau> found;
  for (const StepRange& range :
       ranges.longest({growth.begin, growth.alpha.size()}, plateau_rules::most_plateaus, plateau_rules::least_ratio)) {
    found.push_back(plateau_of(range, growth, ranges.ratio_of(range), distinct));
    count(points.size(), delaunay, radii, step, found.back());
  }
  plateau_rules::rank(found, [&](const SolidPlateau& p) {
    return plateau_rules::Weight{p.is_structured, static_cast<double>(p.covered) / static_cast<double>(distinct)};
  });
  return found;
}

}  // namespace rbpa
