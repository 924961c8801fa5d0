#include "rbpa/plane/representatives.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/filtration/elder_rule.h"
#include "rbpa/plane/filtration/filtered_cells.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/shape/polygons_of_linked.h"

namespace rbpa {
namespace {

/// A pair, and the cell that locates the pair: the edge that ends a component, or the last triangle of a hole.
struct Placed : PersistencePair {
  std::array<std::uint32_t, 2> edge;  // numbers of distinct points
  std::uint32_t triangle;
  double last;  // the last radius at which the hole exists
};

void sort_pairs(std::vector<Placed>& pairs, Steps& pulse) {
  const auto key = [](const Placed& p) {
    return std::tuple(p.dimension, p.birth, !p.death, p.death.value_or(0.0), p.edge, p.triangle);
  };
  sort(pairs, pulse, [&](const Placed& a, const Placed& b) { return key(a) < key(b); });
}

std::vector<Placed> placed_pairs(FilteredCells& cells, Steps& pulse) {
  sort(cells.edges, pulse, [](const FilteredCells::Edge& a, const FilteredCells::Edge& b) {
    return std::tie(a.alpha, a.ends) < std::tie(b.alpha, b.ends);
  });
  std::vector<Placed> pairs;
  pair_components(cells, pulse, [&](const Arrival& birth, const FilteredCells::Edge* ending) {
    if (ending != nullptr)
      pairs.push_back({{0, birth.alpha, ending->alpha}, ending->ends, 0, 0});
    else
      pairs.push_back({{0, birth.alpha, std::nullopt}, {}, 0, 0});
  });
  pair_holes(cells, pulse, [&](double birth, const Arrival& death) {
    pairs.push_back({{1, birth, death.alpha}, {}, death.cell, std::nextafter(death.alpha, 0.0)});
  });
  return pairs;
}

/// Returns the pairs that exist at one of the radii `levels` or more; birth and last are the first and last of these
/// radii, death is the next radius after the last, if there is one.
std::vector<Placed> at_levels(const std::vector<Placed>& pairs, std::span<const double> levels) {
  std::vector<Placed> result;
  for (Placed pair : pairs) {
    const auto first = std::lower_bound(levels.begin(), levels.end(), pair.birth);
    const auto end = pair.death ? std::lower_bound(first, levels.end(), *pair.death) : levels.end();
    if (first == end) continue;
    pair.birth = *first;
    pair.last = *(end - 1);
    pair.death = end == levels.end() ? std::nullopt : std::optional(*end);
    result.push_back(pair);
  }
  return result;
}

/// Removes in each dimension pairs that `choice` does not choose, so that fewer pairs are sorted.
void drop_short(std::vector<Placed>& pairs, const PairChoice& choice) {
  std::array<double, 2> least = {choice.min_persistence, choice.min_persistence};
  for (const int dimension : {0, 1}) {
    std::vector<double> lives;
    for (const Placed& pair : pairs)
      if (pair.dimension == dimension) lives.push_back(persistence_of(pair));
    if (choice.top == 0 || lives.size() <= choice.top) continue;
    const auto last = lives.begin() + static_cast<std::ptrdiff_t>(choice.top - 1);
    std::nth_element(lives.begin(), last, lives.end(), std::greater<>());
    double& bound = least[static_cast<std::size_t>(dimension)];
    bound = std::max(bound, *last);
  }
  std::erase_if(pairs, [&](const Placed& pair) {
    return persistence_of(pair) < least[static_cast<std::size_t>(pair.dimension)];
  });
}

/// Holes of a complex at any radius.
class HoleSearch {
 public:
  /// Keeps references to the data of `delaunay` and `filtration`.
  HoleSearch(const Delaunay& delaunay, const Filtration& filtration, const FilteredCells& cells)
      : points_(delaunay.points()),
        all_(delaunay.triangulation()),
        alpha_(filtration.triangle_alpha),
        number_(alpha_.size(), none),
        place_(points_.size(), none) {
    for (const FilteredCells::Edge& edge : cells.edges) {
      const auto [a, b] = edge.sides;
      if (b == cells.outside() || !(edge.alpha < std::min(alpha_[a], alpha_[b]))) continue;
      if (closes_.empty()) closes_.assign(alpha_.size(), {never, never, never});
      closes_[a][side_towards(b, a)] = edge.alpha;
      closes_[b][side_towards(a, b)] = edge.alpha;
    }
  }

  /// Returns the hole at `alpha` that contains the triangle. Requires: a bounded hole.
  Polygon hole_at(double alpha, std::uint32_t triangle, Steps& pulse) {
    reach(alpha, triangle, pulse);
    // Points are renumbered, so that the cost depends on the size of the hole only.
    std::vector<Point> points;
    std::vector<std::uint32_t> index;
    std::vector<Triangle> triangles, neighbors;
    for (const std::uint32_t t : reached_) {
      triangles.push_back(all_.triangles[t]);
      for (std::uint32_t& corner : triangles.back()) {
        if (place_[corner] == none) {
          place_[corner] = static_cast<std::uint32_t>(index.size());
          index.push_back(corner);
          points.push_back(points_[corner]);
        }
        corner = place_[corner];
      }
      neighbors.push_back(all_.neighbors[t]);
      for (std::uint32_t& beyond : neighbors.back())
        beyond = beyond == AlphaComplex::none || number_[beyond] == none ? AlphaComplex::none : number_[beyond];
    }
    for (const std::uint32_t t : reached_) number_[t] = none;
    for (const std::uint32_t point : index) place_[point] = none;
    // Triangles connected through edges form one polygon.
    Polygon polygon = std::move(polygons_of_linked(points, TriangleArrays{triangles, neighbors}, {}).front());
    const auto rename = [&](Ring& ring) {
      for (std::uint32_t& point : ring.points) point = index[point];
    };
    rename(polygon.shell);
    for (Ring& ring : polygon.holes) rename(ring);
    return polygon;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr double never = std::numeric_limits<double>::infinity();

  std::size_t side_towards(std::uint32_t neighbor, std::uint32_t triangle) const {
    const Triangle& neighbors = all_.neighbors[triangle];
    return static_cast<std::size_t>(std::find(neighbors.begin(), neighbors.end(), neighbor) - neighbors.begin());
  }

  /// Collects in reached_ the triangles that can be reached from `triangle` outside of the complex at `alpha`, and
  /// stores the position of each triangle in number_.
  void reach(double alpha, std::uint32_t triangle, Steps& pulse) {
    reached_ = {triangle};
    number_[triangle] = 0;
    for (std::size_t i = 0; i < reached_.size(); ++i) {
      pulse(2);
      const std::uint32_t t = reached_[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t beyond = all_.neighbors[t][k];
        if (beyond == AlphaComplex::none || alpha_[beyond] <= alpha || number_[beyond] != none ||
            (!closes_.empty() && closes_[t][k] <= alpha))
          continue;
        number_[beyond] = static_cast<std::uint32_t>(reached_.size());
        reached_.push_back(beyond);
      }
    }
  }

  std::span<const Point> points_;
  const AlphaComplex& all_;
  const std::vector<double>& alpha_;
  // for each side: the alpha of its edge, if the edge appears before both of its triangles, otherwise infinity; empty
  // if no edge does
  std::vector<std::array<double, 3>> closes_;
  std::vector<std::uint32_t> reached_, number_, place_;
};

std::vector<Representative> representatives_of(const Delaunay& delaunay, const Filtration& filtration,
                                               std::optional<std::span<const double>> levels, ComplexKind kind,
                                               const PairChoice& choice, const GoOn& go_on) {
  Steps pulse(go_on);
  const DistinctPoints distinct = distinct_points(delaunay);
  FilteredCells cells = filtered_cells(delaunay, distinct, filtration, kind, pulse);
  HoleSearch holes(delaunay, filtration, cells);  // before edges are sorted by alpha: neighbors are near in memory
  std::vector<Placed> pairs = placed_pairs(cells, pulse);
  if (levels) pairs = at_levels(pairs, *levels);
  drop_short(pairs, choice);
  sort_pairs(pairs, pulse);
  pairs = chosen(pairs, choice);
  std::vector<Representative> result;
  result.reserve(pairs.size());
  for (const Placed& pair : pairs) {
    pulse(64);
    Representative& one = result.emplace_back(Representative{.pair = pair});
    if (pair.dimension == 1) {
      one.at_birth = holes.hole_at(pair.birth, pair.triangle, pulse);
      one.before_death = holes.hole_at(pair.last, pair.triangle, pulse);
    } else if (pair.death) {
      one.joined_at = {distinct.index[pair.edge[0]], distinct.index[pair.edge[1]]};
      std::sort(one.joined_at->begin(), one.joined_at->end());
    }
  }
  return result;
}

}  // namespace

std::vector<Representative> representatives(const Delaunay& delaunay, const Filtration& filtration, ComplexKind kind,
                                            const PairChoice& choice, const GoOn& go_on) {
  require_same(filtration, delaunay.triangulation(), "representatives");
  return representatives_of(delaunay, filtration, std::nullopt, kind, choice, go_on);
}

std::vector<Representative> level_representatives(const Delaunay& delaunay, const Filtration& filtration,
                                                  std::span<const double> levels, ComplexKind kind,
                                                  const PairChoice& choice, const GoOn& go_on) {
  require_same(filtration, delaunay.triangulation(), "level_representatives");
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (!(levels[i] > (i == 0 ? 0 : levels[i - 1])))
      throw meshops::ContractViolation("level_representatives: found radius " + text(levels[i]) +
                                       (i == 0 ? "" : " after " + text(levels[i - 1])) +
                                       ", expected radii above 0 that strictly ascend");
  return representatives_of(delaunay, filtration, levels, kind, choice, go_on);
}

}  // namespace rbpa
