#include "rbpa/space/balls/pore_sizes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/balls/full/orthoball.h"
#include "rbpa/space/balls/periodic/periodic_regular.h"
#include "rbpa/space/balls/periodic_voids.h"
#include "rbpa/space/predicate/outer_faces.h"
#include "rbpa/space/predicate/spread.h"

namespace rbpa {
namespace {

using space::Boxes;
using space::Orthoball;
using space::PeriodicRegular;

/// The narrowest place of the widest path along an edge of the cell, among balls that are grown.
struct Neck {
  double power = -std::numeric_limits<double>::infinity();  ///< what closes it, added to the squared radii
  double radius = 0;  ///< of the ball that touches the grown balls there; below 0 if they overlap; or not a number
};

/// Disjoint sets of tetrahedra, each at a place: numbers of edges from the root of its set.
class PlacedSets {
 public:
  explicit PlacedSets(std::size_t size) : parent_(size), place_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  /// Joins i with j moved by `moved`. Returns how far j is moved on the way around if they were joined already, else 0.
  Boxes join(std::uint32_t i, std::uint32_t j, const Boxes& moved) {
    const Boxes to_i = find(i), to_j = find(j);
    const Boxes apart = space::minus(space::plus(to_i, moved), to_j);
    if (i == j) return apart;
    parent_[j] = i;
    place_[j] = apart;
    return {};
  }

 private:
  /// Replaces i by the root of its set. Returns the place of i.
  Boxes find(std::uint32_t& i) {
    Boxes place{};
    while (parent_[i] != i) {
      const std::uint32_t above = parent_[i];
      if (parent_[above] != above) place_[i] = space::plus(place_[i], place_[above]);
      place = space::plus(place, place_[i]);
      i = parent_[i] = parent_[above];
    }
    return place;
  }

  std::vector<std::uint32_t> parent_;
  std::vector<Boxes> place_;
};

/// A triangle between two tetrahedra, with what closes it.
struct Gate {
  Neck neck;
  std::uint32_t kept, across;
};

/// Returns the triangles, the last to close first.
std::vector<Gate> gates_of(const PeriodicRegular& regular) {
  const space::Spread scale = space::spread(regular.centers, regular.radii);
  std::vector<Point3> copy_of_centers;
  std::vector<double> copy_of_radii;
  const auto centers = space::scaled(regular.centers, scale, copy_of_centers);
  const auto radii = space::scaled(regular.radii, scale, copy_of_radii);
  const auto ball = [&](std::uint32_t image) { return space::Ball{centers[image], radii[image]}; };
  const auto neck_of = [&](const auto& simplex) {
    std::array<space::Ball, std::tuple_size_v<std::decay_t<decltype(simplex)>>> balls{};
    for (std::size_t k = 0; k < balls.size(); ++k) balls[k] = ball(simplex[k]);
    const Orthoball found = space::orthoball(balls);
    return Neck{found.power, std::ldexp(found.touching.radius, -scale.exponent)};
  };
  const auto& [simplices, neighbors] = std::tie(regular.cells.simplices, regular.cells.neighbors);
  std::vector<Neck> necks;
  for (const std::uint32_t t : regular.kept) necks.push_back(neck_of(simplices[t]));
  std::vector<Gate> gates;
  for (std::uint32_t i = 0; i < regular.kept.size(); ++i)
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t other = regular.neighbors[i][k].t;
      if (other < i) continue;
      const std::uint32_t t = regular.kept[i], beyond = neighbors[t][k];
      const auto back = std::find(neighbors[beyond].begin(), neighbors[beyond].end(), t) - neighbors[beyond].begin();
      const auto face = space::outer_face(simplices[t], k);
      const space::Ball a = ball(face[0]), b = ball(face[1]), c = ball(face[2]);
      const auto is_attached = [&](std::uint32_t corner) { return space::is_conflict(a, b, c, ball(corner)); };
      const bool is_closed_first =
          is_attached(simplices[t][k]) || is_attached(simplices[beyond][static_cast<std::size_t>(back)]);
      gates.push_back({!is_closed_first                      ? neck_of(face)
                       : necks[other].power < necks[i].power ? necks[other]
                                                             : necks[i],
                       i, k});
    }
  std::stable_sort(gates.begin(), gates.end(),
                   [](const Gate& a, const Gate& b) { return a.neck.power > b.neck.power; });
  return gates;
}

/// Returns the neck along each edge of the cell.
std::array<Neck, 3> necks_along(const PeriodicRegular& regular) {
  std::array<Neck, 3> necks{};
  std::array<bool, 3> is_found{};
  PlacedSets sets(regular.kept.size());
  for (const Gate& gate : gates_of(regular)) {
    const auto& [other, moved] = regular.neighbors[gate.kept][gate.across];
    const Boxes around = sets.join(gate.kept, other, moved);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::int64_t edges = 0;
      for (std::size_t k = 0; k < 3; ++k) edges += around[k] * regular.edges[k][axis];
      if (edges == 0 || is_found[axis]) continue;
      is_found[axis] = true;
      necks[axis] = gate.neck;
    }
    if (is_found == std::array{true, true, true}) break;
  }
  return necks;
}

/// The search for the radius of the ball that passes along an edge.
struct Search {
  double low = 0, high;  // a ball of radius low passes; none of radius high does
  double next = 0;       // the radius to try next, or the one found
  bool is_done = false;

  void update(double tried, const Neck& neck, double tolerance) {
    const bool passes = neck.power > 0;
    if (passes)
      low = std::max(low, tried);
    else
      high = std::min(high, tried);
    next = tried + neck.radius;
    is_done = std::abs(neck.radius) <= tolerance || !(high - low > tolerance);
    if (is_done ? !(next >= low && next <= high) : !(next > low && next < high))
      next = is_done ? low : low + (high - low) / 2;
    if (!passes && tried == 0) {
      next = 0;
      is_done = true;
    }
  }
};

}  // namespace

PoreSizes pore_sizes(std::span<const Point3> centers, std::span<const double> radii, const RepeatingCell& cell,
                     const SolidOptions& options) {
  if (centers.empty()) throw InvalidInput("found no balls, expected at least one");
  PoreSizes sizes;
  const auto grown = [&](double growth) {
    std::vector<double> all(radii.begin(), radii.end());
    for (double& radius : all) radius += growth;
    return all;
  };
  const auto largest_in = [&](double growth, unsigned dimension) {
    double largest = 0;
    for (const BallVoid& of : periodic_ball_voids(centers, grown(growth), cell, options).voids)
      if (of.dimension >= dimension) largest = std::max(largest, of.radius + growth);
    return largest;
  };
  sizes.included = largest_in(0, 0);
  const double tolerance = 0x1p-42 * (sizes.included + *std::max_element(radii.begin(), radii.end()));
  std::array<Search, 3> along;
  along.fill({.high = sizes.included * (1 + 0x1p-40)});
  while (true) {
    const auto open = std::find_if(along.begin(), along.end(), [](const Search& of) { return !of.is_done; });
    if (open == along.end()) break;
    const double growth = open->next;
    const std::array<Neck, 3> necks = necks_along(space::periodic_regular(centers, grown(growth), cell, 0, options));
    for (std::size_t k = 0; k < 3; ++k)
      if (!along[k].is_done) along[k].update(growth, necks[k], tolerance);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    sizes.along[k] = along[k].next;
    sizes.passing = std::max(sizes.passing, along[k].next);
  }
  if (sizes.passing > 0) sizes.on_the_way = std::min(largest_in(sizes.passing * (1 - 0x1p-30), 1), sizes.included);
  return sizes;
}

}  // namespace rbpa
