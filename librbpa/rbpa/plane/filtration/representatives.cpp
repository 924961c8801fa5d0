#include "rbpa/representatives.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "rbpa/base/steps.h"
#include "rbpa/plane/filtration/elder_rule.h"
#include "rbpa/plane/filtration/filtered_cells.h"
#include "rbpa/plane/filtration/filtered_triangles.h"

namespace rbpa {
namespace {

/// A pair, and a cell where it is: the edge at which it ends, or its last triangle.
struct Placed : PersistencePair {
  std::array<std::uint32_t, 2> edge;  // numbers of distinct points
  std::uint32_t triangle;
};

std::vector<Placed> placed_pairs(FilteredCells& cells, Steps& pulse) {
  sort(cells.edges, pulse, [](const FilteredCells::Edge& a, const FilteredCells::Edge& b) {
    return std::tie(a.alpha, a.ends) < std::tie(b.alpha, b.ends);
  });
  std::vector<Placed> pairs;
  pair_components(cells, pulse, [&](const Arrival& birth, const FilteredCells::Edge* ending) {
    if (ending != nullptr)
      pairs.push_back({{0, birth.alpha, ending->alpha}, ending->ends, 0});
    else
      pairs.push_back({{0, birth.alpha, std::nullopt}, {}, 0});
  });
  pair_holes(cells, pulse, [&](double birth, const Arrival& death) {
    pairs.push_back({{1, birth, death.alpha}, {}, death.cell});
  });
  const auto key = [](const Placed& p) {
    return std::tuple(p.dimension, p.birth, !p.death, p.death.value_or(0.0), p.edge, p.triangle);
  };
  sort(pairs, pulse, [&](const Placed& a, const Placed& b) { return key(a) < key(b); });
  return pairs;
}

/// Holes of a complex at any radius.
class HoleSearch {
 public:
  /// Keeps references. Of the edges, only those that come before both of their triangles are blocked by themselves.
  HoleSearch(const Delaunay& delaunay, const Filtration& filtration, const FilteredCells& cells)
      : delaunay_(delaunay), alpha_(filtration.triangle_alpha) {
    for (const FilteredCells::Edge& edge : cells.edges)
      if (edge.sides[1] != cells.outside() && edge.alpha < std::min(alpha_[edge.sides[0]], alpha_[edge.sides[1]]))
        free_.emplace(key(edge.sides[0], edge.sides[1]), edge.alpha);
  }

  /// That with this triangle. Requires: a bounded one.
  Polygon hole_at(double alpha, std::uint32_t triangle, Steps& pulse) const {
    const Triangulation& all = delaunay_.triangulation();
    std::unordered_map<std::uint32_t, std::uint32_t> number = {{triangle, 0}};
    std::vector<std::uint32_t> reached = {triangle};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      pulse(2);
      for (const std::uint32_t beyond : all.neighbors[reached[i]])
        if (beyond != Triangulation::none && alpha_[beyond] > alpha && !is_closed(reached[i], beyond, alpha) &&
            number.emplace(beyond, static_cast<std::uint32_t>(reached.size())).second)
          reached.push_back(beyond);
    }
    std::vector<Triangle> triangles, neighbors;
    for (const std::uint32_t t : reached) {
      triangles.push_back(all.triangles[t]);
      neighbors.push_back(all.neighbors[t]);
      for (std::uint32_t& beyond : neighbors.back()) {
        const auto found = number.find(beyond);
        beyond = found == number.end() ? Triangulation::none : found->second;
      }
    }
    // Triangles that hang together through edges: one polygon.
    return polygons(delaunay_.points(), TriangleArrays{triangles, neighbors}).front();
  }

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
  }
  bool is_closed(std::uint32_t a, std::uint32_t b, double alpha) const {
    const auto found = free_.find(key(a, b));
    return found != free_.end() && found->second <= alpha;
  }

  const Delaunay& delaunay_;
  const std::vector<double>& alpha_;
  std::unordered_map<std::uint64_t, double> free_;  // by the triangles beside it
};

}  // namespace

std::vector<Representative> representatives(const Delaunay& delaunay, const Filtration& filtration, ComplexKind kind,
                                            const PairChoice& choice, const std::function<bool()>& go_on) {
  require_same(filtration, delaunay.triangulation(), "representatives");
  Steps pulse(go_on);
  const DistinctPoints distinct = distinct_points(delaunay);
  FilteredCells cells = filtered_cells(delaunay, distinct, filtration, kind, pulse);
  const std::vector<Placed> pairs = chosen(placed_pairs(cells, pulse), choice);
  const HoleSearch holes(delaunay, filtration, cells);
  std::vector<Representative> result;
  for (const Placed& pair : pairs) {
    pulse(64);
    Representative& one = result.emplace_back(Representative{.pair = pair});
    if (pair.dimension == 1) {
      one.at_birth = holes.hole_at(pair.birth, pair.triangle, pulse);
      one.before_death = holes.hole_at(std::nextafter(*pair.death, 0.0), pair.triangle, pulse);
    } else if (pair.death) {
      one.joined_at = {distinct.index[pair.edge[0]], distinct.index[pair.edge[1]]};
      std::sort(one.joined_at->begin(), one.joined_at->end());
    }
  }
  return result;
}

}  // namespace rbpa
