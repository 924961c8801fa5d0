#include "rbpa/space/balls/weighted_filtration.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "rbpa/base/run/input.h"
#include "rbpa/space/balls/regular_triangulation.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/persistence/pairing/curve_order.h"
#include "rbpa/space/persistence/pairing/values_of_faces.h"
#include "rbpa/space/predicate/orthosphere.h"

namespace rbpa {
namespace {

using space::Ball;

/// The rule for values_of_faces.h: values are powers of orthocenters.
class PowerRule {
 public:
  PowerRule(std::span<const Point3> centers, std::span<const double> radii, bool roots)
      : centers_(centers), radii_(radii), roots_(roots) {}

  template <std::size_t corners>
  double value(const std::array<std::uint32_t, corners>& simplex) const {
    std::array<Ball, corners> balls;
    for (std::size_t k = 0; k < corners; ++k) balls[k] = ball(simplex[k]);
    return space::least_power_rounded_up(balls, roots_);
  }

  struct Face {
    const PowerRule& rule;
    const Triangle& corners;
    bool conflicts(std::uint32_t corner) const {
      return space::is_conflict(rule.ball(corners[0]), rule.ball(corners[1]), rule.ball(corners[2]), rule.ball(corner));
    }
    double value() const { return rule.value(corners); }
  };
  Face triangle(const Triangle& corners) const { return {*this, corners}; }
  std::uint8_t conflicts(const Triangle& corners) const {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (space::is_conflict(ball(corners[(k + 1) % 3]), ball(corners[(k + 2) % 3]), ball(corners[k]))) bits |= 1u << k;
    return static_cast<std::uint8_t>(bits);
  }
  bool conflicts(std::uint32_t i, std::uint32_t other) const { return space::is_conflict(ball(i), ball(other)); }

 private:
  Ball ball(std::uint32_t i) const { return {centers_[i], radii_[i]}; }

  std::span<const Point3> centers_;
  std::span<const double> radii_;
  bool roots_;
};

/// Computes the values of many simplices, which threads share.
template <typename Simplices>
std::vector<double> values_of(const PowerRule& rule, const Simplices& simplices, Threads& threads, const GoOn& go_on) {
  std::vector<double> values(simplices.size());
  CheckpointOfThreads checkpoint(go_on);
  for_each_part(threads, values.size(), space::faces_at_a_time, [&](std::size_t begin, std::size_t end) {
    checkpoint();
    for (std::size_t i = begin; i < end; ++i) values[i] = rule.value(simplices[i]);
  });
  return values;
}

/// Fills in triangles, edges and values from the triangulation of centers in one plane or on one line.
void take_flat(std::span<const std::array<std::uint32_t, 4>> flat, const PowerRule& rule, std::size_t balls,
               Threads& threads, const GoOn& go_on, Steps& step, SolidFiltration& filtration) {
  for (const auto& [a, b, c, none] : flat) {
    if (c != none)
      filtration.triangles.push_back({a, b, c});
    else if (b != none)
      filtration.edges.push_back({a, b});
  }
  filtration.triangle_alpha = values_of(rule, filtration.triangles, threads, go_on);
  if (filtration.triangles.empty()) return;
  // An edge may be the side of a single triangle, but number_edges() requires two: each triangle is given twice.
  std::vector<Triangle> twice = filtration.triangles;
  twice.insert(twice.end(), filtration.triangles.begin(), filtration.triangles.end());
  space::NumberedEdges edges = space::number_edges(balls, twice, step);
  filtration.edges = std::move(edges.ends);
  edges.of.resize(filtration.triangles.size());
  filtration.edges_of = std::move(edges.of);
}

/// Fills in point_alpha: a ball whose center is in its cell has its own value, any other ball the least value of its
/// edges.
void find_values_of_balls(const PowerRule& rule, std::size_t balls, const RegularTriangulation& regular, Steps& step,
                          SolidFiltration& filtration) {
  std::vector<std::uint8_t> is_alone(balls, 1);
  for (const std::uint32_t i : regular.hidden) is_alone[i] = 0;
  for (const Duplicate& duplicate : regular.duplicates) is_alone[duplicate.index] = 0;
  filtration.point_alpha.assign(balls, std::numeric_limits<double>::infinity());
  auto& alpha = filtration.point_alpha;
  for (std::size_t i = 0; i < filtration.edges.size(); ++i) {
    step();
    const auto [a, b] = filtration.edges[i];
    for (const auto& [own, other] : {std::pair(a, b), std::pair(b, a)}) {
      alpha[own] = std::min(alpha[own], filtration.edge_alpha[i]);
      if (rule.conflicts(own, other)) is_alone[own] = 0;
    }
  }
  for (std::uint32_t i = 0; i < balls; ++i)
    if (is_alone[i] != 0) alpha[i] = rule.value(std::array{i});
}

}  // namespace

/// Computes the filtration in the steps of solid_filtration().
SolidFiltration weighted_filtration(std::span<const Point3> centers, std::span<const double> radii,
                                    const WeightedFiltrationOptions& options) {
  space::check_balls(centers, radii);
  Threads threads = threads_for(centers.size(), options.threads);
  const space::CurveOrder order(centers, threads, checkpoint_of(options.progress, centers.size()));
  const std::vector<Point3> sorted = order.sorted(centers);
  const std::vector<double> sorted_radii = order.sorted(radii);
  RegularTriangulation regular =
      regular_triangulation(sorted, sorted_radii, {.threads = options.threads, .progress = options.progress});

  SolidFiltration filtration;
  const GoOn go_on = go_on_of(options.progress, regular.distinct);
  Steps step(go_on);
  const PowerRule rule(sorted, sorted_radii, options.roots);
  filtration.delaunay.simplices = std::move(regular.simplices);
  filtration.delaunay.neighbors = std::move(regular.neighbors);
  if (filtration.delaunay.simplices.empty()) {
    take_flat(regular.flat, rule, sorted.size(), threads, go_on, step, filtration);
  } else {
    const auto values = [&](const GoOn& goes_on) {
      return values_of(rule, filtration.delaunay.simplices, threads, goes_on);
    };
    space::find_faces(rule, sorted.size(), values, threads, go_on, filtration);
  }
  space::find_values_of_edges(rule, threads, go_on, filtration);
  find_values_of_balls(rule, sorted.size(), regular, step, filtration);
  filtration.delaunay.duplicates = std::move(regular.duplicates);
  filtration.delaunay.isolated = std::move(regular.hidden);
  filtration.delaunay.distinct = regular.distinct;
  order.rename_corners(threads, filtration);
  return filtration;
}

}  // namespace rbpa
