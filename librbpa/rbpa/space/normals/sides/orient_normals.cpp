#include "rbpa/space/normals/sides/orient_normals.h"

#include <algorithm>
#include <array>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "rbpa/space/normals/sides/compare_normals.h"

namespace rbpa::space {
namespace {

using Number = std::uint32_t;
using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                 boost::no_property, Number, std::size_t>;

/// Returns the weight of an edge in the spanning tree. Little weight is given to edges of little doubt, and to edges
/// along the surface, because noise decides across the surface.
double weight(const NormalComparison& c) { return std::max(0.0, 1 - std::abs(c.agreement)) + c.tilt; }

/// Finds the points at which the tree begins: those whose sides are known; and in each component of the graph without
/// such points, one point, whose normal is turned outward.
class Seeds {
 public:
  Seeds(const Neighborhoods& points, std::span<Point3> normals, std::span<const std::int8_t> sides)
      : points_(points), normals_(normals), sides_(sides) {}

  std::vector<Number> find() {
    const std::size_t size = points_.points.size();
    std::vector<Number> rank(size), parent(size);
    const auto map = [](std::vector<Number>& values) {
      return boost::make_iterator_property_map(values.begin(), boost::identity_property_map());
    };
    boost::disjoint_sets sets(map(rank), map(parent));
    for (Number i = 0; i < size; ++i) sets.make_set(i);
    for (Number i = 0; i < size; ++i)
      for (const Number j : points_.around(i)) sets.union_set(i, j);

    std::vector<Number> component(size);  // for each root of `sets`, the number of its component of the graph
    std::vector<Extremes> extremes;
    for (Number i = 0; i < size; ++i)
      if (sets.find_set(i) == i) {
        component[i] = static_cast<Number>(extremes.size());
        extremes.push_back({i, i, i, i, i, i});
      }
    for (Number i = 0; i < size; ++i) {
      Extremes& of_component = extremes[component[sets.find_set(i)]];
      for (std::size_t d = 0; d < of_component.size(); ++d)
        if (is_farther(i, of_component[d], d)) of_component[d] = i;
    }
    std::vector<Number> seeds;
    std::vector<bool> has_seed(extremes.size(), false);
    for (Number i = 0; i < sides_.size(); ++i) {
      if (sides_[i] == 0) continue;
      if (sides_[i] < 0) normals_[i] = turned(normals_[i]);
      seeds.push_back(i);
      has_seed[component[sets.find_set(i)]] = true;
    }
    for (std::size_t c = 0; c < extremes.size(); ++c)
      if (!has_seed[c]) seeds.push_back(turn_one(extremes[c]));
    return seeds;
  }

 private:
  using Extremes = std::array<Number, 6>;  // extreme points in the directions +z, −z, +y, −y, +x, −x

  static double along(const Point3& p, std::size_t direction) {
    const double coordinate = direction < 2 ? p.z : direction < 4 ? p.y : p.x;
    return direction % 2 == 0 ? coordinate : -coordinate;
  }
  bool is_farther(Number i, Number j, std::size_t direction) const {
    const double a = along(points_.points[i], direction), b = along(points_.points[j], direction);
    if (a != b) return a > b;
    const double m = std::abs(along(normals_[i], direction)), n = std::abs(along(normals_[j], direction));
    return m != n ? m > n : points_.points[i] > points_.points[j];
  }
  Number turn_one(const Extremes& extremes) {
    const auto confidence = [&](std::size_t d) { return std::abs(along(normals_[extremes[d]], d)); };
    std::size_t best = 0;
    for (std::size_t d = 0; d < extremes.size(); ++d) {
      if (confidence(d) > confidence(best)) best = d;
      if (confidence(d) >= 0.5) {
        best = d;
        break;
      }
    }
    Point3& normal = normals_[extremes[best]];
    if (along(normal, best) < 0) normal = turned(normal);
    return extremes[best];
  }

  const Neighborhoods& points_;
  std::span<Point3> normals_;
  std::span<const std::int8_t> sides_;
};

/// Returns the graph: edges in both directions between each point and its nearest others, and edges from one more
/// vertex, the root, to the points at which the tree begins.
Graph graph_of(const Neighborhoods& points, const std::vector<Number>& seeds) {
  const auto root = static_cast<Number>(points.points.size());
  const auto for_each_edge = [&](auto visit) {
    for (Number i = 0; i < root; ++i)
      for (const Number j : points.around(i)) {
        visit(i, j);
        const auto back = points.around(j);
        if (std::find(back.begin(), back.end(), i) == back.end()) visit(j, i);
      }
    for (const Number seed : seeds) visit(root, seed);
  };
  std::vector<std::size_t> begin(root + std::size_t{2});
  for_each_edge([&](Number from, Number) { ++begin[from + std::size_t{1}]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::pair<Number, Number>> edges(begin.back());  // sorted by the vertices at which they begin
  for_each_edge([&](Number from, Number to) { edges[begin[from]++] = {from, to}; });
  return {boost::edges_are_sorted, edges.begin(), edges.end(), root + Number{1}, edges.size()};
}

/// Visitor that turns the normal of each vertex that the tree reaches to the side of the parent's normal.
template <typename Real>
class Turn : public boost::default_dijkstra_visitor {
 public:
  Turn(const Neighborhoods& points, std::span<Point3> normals, const std::vector<Number>& from,
       std::vector<Number>& order, const Checkpoint& go_on)
      : points_(points), normals_(normals), from_(from), order_(order), go_on_(go_on) {}

  void examine_vertex(Number v, const Graph&) {
    order_.push_back(v);
    const Number u = from_[v];
    const std::size_t root = points_.points.size();
    if (v != root && u != root &&
        compare_normals<Real>(points_.points[u], normals_[u], points_.points[v], normals_[v]).agreement < 0)
      normals_[v] = turned(normals_[v]);
    constexpr Number vertices_at_a_time = 4096;
    if (go_on_ && order_.size() % vertices_at_a_time == 0) go_on_();
  }

 private:
  const Neighborhoods& points_;
  std::span<Point3> normals_;
  const std::vector<Number>& from_;
  std::vector<Number>& order_;
  const Checkpoint& go_on_;
};

}  // namespace

template <typename Real>
OrientationTree orient_normals(const Neighborhoods& points, std::span<Point3> normals, const Checkpoint& go_on,
                               std::span<const std::int8_t> sides) {
  const Graph graph = graph_of(points, Seeds(points, normals, sides).find());
  const auto root = static_cast<Number>(points.points.size());
  OrientationTree tree;
  std::vector<Number>& from = tree.parent;
  from.resize(root + std::size_t{1});
  std::iota(from.begin(), from.end(), Number{0});
  tree.order.reserve(from.size());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> least(from.size(), infinity);
  least[root] = 0;
  std::vector<boost::default_color_type> color(from.size(), boost::white_color);
  const auto index = boost::get(boost::vertex_index, graph);
  const auto map = [&](auto& values) { return boost::make_iterator_property_map(values.begin(), index); };
  const auto weight_of = [&](const boost::graph_traits<Graph>::edge_descriptor& edge) {
    const Number u = boost::source(edge, graph), v = boost::target(edge, graph);
    return u == root ? 0.0 : weight(compare_normals<Real>(points.points[u], normals[u], points.points[v], normals[v]));
  };
  // Prim's algorithm as in Boost.Graph: Dijkstra's algorithm with the weight of the last edge as distance. Turning a
  // normal changes no weight.
  boost::dijkstra_shortest_paths_no_init(
      graph, root, map(from), map(least),
      boost::make_function_property_map<boost::graph_traits<Graph>::edge_descriptor, double>(weight_of), index,
      std::less<>(), [](double, double last) { return last; }, 0.0,
      Turn<Real>(points, normals, from, tree.order, go_on), map(color));
  return tree;
}

template OrientationTree orient_normals<double>(const Neighborhoods&, std::span<Point3>, const Checkpoint&,
                                                std::span<const std::int8_t>);
template OrientationTree orient_normals<long double>(const Neighborhoods&, std::span<Point3>, const Checkpoint&,
                                                     std::span<const std::int8_t>);

}  // namespace rbpa::space
