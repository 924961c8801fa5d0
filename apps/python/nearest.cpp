#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "python/module.h"
#include "rbpa/base/error.h"

namespace rbpa::python {
namespace {

using Real = long double;  // its range of exponents holds squares of coordinates
using Vector = std::array<Real, 3>;
using Weights = std::array<double, 3>;

Vector coordinates(const Point3& p) { return {p.x, p.y, p.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A search structure for the nearest positions on facets: triangles; segments, as triangles whose last two corners are
/// equal; and points, as triangles with three equal corners. A tree of boxes halves the facets along the longest side
/// of each box.
class NearestPlaces {
 public:
  /// Views `points` and `facets`, and keeps these arrays alive.
  NearestPlaces(Doubles points, Indices facets)
      : points_array_(std::move(points)),
        facets_array_(std::move(facets)),
        points_(points3_of(points_array_, "points")),
        facets_(triples_of(facets_array_, "facets")),
        order_(facets_.size()) {
    for (const Triple& facet : facets_)
      for (const std::uint32_t corner : facet)
        if (corner >= points_.size())
          throw py::value_error("facets: found the corner " + std::to_string(static_cast<std::int32_t>(corner)) +
                                ", expected indices of points, at least 0 and below " + std::to_string(points_.size()));
    std::iota(order_.begin(), order_.end(), 0U);
    if (!order_.empty()) build(0, order_.size());
  }

  /// Returns for each query the nearest facet, and the weights of its corners at the nearest position. Of equally near
  /// facets, returns the first.
  std::pair<Indices, Doubles> find(const Doubles& queries) const {
    const auto input = points3_of(queries, "queries");
    if (facets_.empty()) throw py::value_error("facets: found none, expected at least one");
    std::vector<std::uint32_t> facet(input.size());
    std::vector<Weights> weights(input.size());
    watched(input.size(), py::none(), [&](Watch& watch) {
      constexpr std::size_t at_a_time = 256;
      for (std::size_t i = 0; i < input.size(); ++i) {
        if (i % at_a_time == 0 && !watch.go_on()) throw Cancelled();
        std::tie(facet[i], weights[i]) = nearest(coordinates(input[i]));
      }
      return true;
    });
    return {line<std::int32_t>(std::move(facet)), rows<double>(std::move(weights))};
  }

 private:
  struct Place {
    Real square = std::numeric_limits<Real>::infinity();  ///< square of the distance
    Weights weights{};
  };
  struct Box {
    Vector low, high;
    std::size_t begin, end;    // range of facets in order_
    std::size_t second_child;  // index of the second child, 0 without children; the first child follows the box
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    constexpr std::size_t few = 4;
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}, begin, end, 0};
    for (std::size_t i = begin; i < end; ++i)
      for (const std::uint32_t corner : facets_[order_[i]]) {
        const Vector p = coordinates(points_[corner]);
        for (std::size_t k = 0; k < 3; ++k) {
          box.low[k] = std::min(box.low[k], p[k]);
          box.high[k] = std::max(box.high[k], p[k]);
        }
      }
    const std::size_t number = boxes_.size();
    boxes_.push_back(box);
    if (end - begin <= few) return number;
    const Vector size = box.high - box.low;
    const auto k = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    const auto key = [&](std::uint32_t facet) {
      const auto& [a, b, c] = facets_[facet];
      return coordinates(points_[a])[k] + coordinates(points_[b])[k] + coordinates(points_[c])[k];
    };
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    build(begin, middle);
    const std::size_t second = build(middle, end);
    boxes_[number].second_child = second;
    return number;
  }

  std::pair<std::uint32_t, Weights> nearest(const Vector& q) const {
    Place best;
    std::uint32_t facet = 0;
    std::vector<std::pair<Real, std::size_t>> open = {{distance(q, boxes_[0]), 0}};
    while (!open.empty()) {
      const auto [square, number] = open.back();
      open.pop_back();
      if (square > best.square) continue;
      const Box& box = boxes_[number];
      if (box.second_child == 0) {
        for (std::size_t i = box.begin; i < box.end; ++i) {
          const Place place = on_facet(q, facets_[order_[i]]);
          if (place.square > best.square || (place.square == best.square && order_[i] > facet)) continue;
          best = place;
          facet = order_[i];
        }
        continue;
      }
      std::pair<Real, std::size_t> first = {distance(q, boxes_[number + 1]), number + 1},
                                   second = {distance(q, boxes_[box.second_child]), box.second_child};
      if (first.first < second.first) std::swap(first, second);
      open.push_back(first);
      open.push_back(second);  // the nearer child is on top, and thus next
    }
    return {facet, best.weights};
  }

  static Real distance(const Vector& q, const Box& box) {
    Real square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Real beyond = std::max({Real{0}, box.low[k] - q[k], q[k] - box.high[k]});
      square += beyond * beyond;
    }
    return square;
  }

  Place on_facet(const Vector& q, const Triple& facet) const {
    std::array<Vector, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = coordinates(points_[facet[k]]);
    Place best;
    const bool is_segment = facet[1] == facet[2];
    for (std::size_t k = 0; k < (is_segment ? 1U : 3U); ++k) {  // for each side of the facet
      const Vector &a = corner[k], side = corner[(k + 1) % 3] - a, to = q - a;
      const Real length = dot(side, side), t = length > 0 ? std::clamp(dot(to, side) / length, Real{0}, Real{1}) : 0;
      const Vector away = {to[0] - t * side[0], to[1] - t * side[1], to[2] - t * side[2]};
      const Real square = dot(away, away);
      if (!(square < best.square)) continue;
      best.square = square;
      best.weights = {};
      best.weights[(k + 1) % 3] = static_cast<double>(t);
      best.weights[k] = 1 - best.weights[(k + 1) % 3];
    }
    if (is_segment) return best;
    const Vector normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const Real all = dot(normal, normal), height = dot(normal, q - corner[0]);
    if (!(all > 0) || !(height * height / all < best.square)) return best;
    std::array<Real, 3> part;
    for (std::size_t k = 0; k < 3; ++k) {
      part[k] = dot(normal, cross(corner[(k + 2) % 3] - corner[(k + 1) % 3], q - corner[(k + 1) % 3]));
      if (!(part[k] >= 0)) return best;
    }
    best.square = height * height / all;
    for (std::size_t k = 0; k < 3; ++k) best.weights[k] = static_cast<double>(part[k] / all);
    return best;
  }

  Doubles points_array_;
  Indices facets_array_;
  std::span<const Point3> points_;
  std::span<const Triple> facets_;
  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;
};

}  // namespace

void bind_nearest(py::module_& module) {
  py::class_<NearestPlaces>(module, "NearestPlaces",
                            "Finds the positions on triangles in space that are nearest to points.")
      .def(py::init<Doubles, Indices>(), as_is("points"), as_is("facets"))
      .def("find", &NearestPlaces::find, as_is("queries"));
}

}  // namespace rbpa::python
