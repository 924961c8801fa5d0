#include "rbpa/space/persistence/solid_representatives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/pairing/cycles.h"
#include "rbpa/space/persistence/pairing/pairing.h"
#include "rbpa/space/predicate/outer_faces.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa {
namespace {

/// A search for the tetrahedra of a void at one radius, and for the triangles around them.
class VoidSearch {
 public:
  VoidSearch(std::span<const Point3> points, const SolidFiltration& filtration)
      : points_(points), filtration_(filtration), is_reached_(filtration.triangles_of.size(), false) {}

  /// Returns the void that contains `tetrahedron` at `alpha`. Throws ContractViolation, with the index `pair` in its
  /// message, if the void is not bounded.
  SolidRepresentative of(std::uint32_t tetrahedron, double alpha, std::size_t pair, Steps& step) {
    SolidRepresentative result;
    auto& reached = result.tetrahedra;
    reached = {tetrahedron};
    is_reached_[tetrahedron] = true;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      step(2);
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t triangle = filtration_.triangles_of[reached[i]][k];
        if (filtration_.triangle_alpha[triangle] <= alpha) continue;
        const std::uint32_t beyond = filtration_.delaunay.neighbors[reached[i]][k];
        meshops::require(beyond != Solid::none, "solid_representatives: pair ", static_cast<long long>(pair),
                         " has a void that reaches the outside, expected pairs of solid_persistence() of this "
                         "filtration");
        if (is_reached_[beyond]) continue;
        is_reached_[beyond] = true;
        reached.push_back(beyond);
      }
    }
    for (const std::uint32_t t : reached) is_reached_[t] = false;
    std::sort(reached.begin(), reached.end());
    add_faces(result);
    measure(result);
    return result;
  }

 private:
  using Vector = space::Vector3<double>;

  /// Adds the triangles that have a tetrahedron of `result` on exactly one side.
  void add_faces(SolidRepresentative& result) const {
    struct Side {
      std::uint32_t triangle, tetrahedron;
      std::size_t corner;
    };
    std::vector<Side> sides;
    for (const std::uint32_t t : result.tetrahedra)
      for (std::size_t k = 0; k < 4; ++k) sides.push_back({filtration_.triangles_of[t][k], t, k});
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.triangle < b.triangle; });
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (i + 1 < sides.size() && sides[i].triangle == sides[i + 1].triangle) {
        ++i;
        continue;
      }
      result.cells.push_back(sides[i].triangle);
      result.faces.push_back(space::outer_face(filtration_.delaunay.simplices[sides[i].tetrahedron], sides[i].corner));
    }
  }
  void measure(SolidRepresentative& result) const {
    for (const std::uint32_t t : result.tetrahedra)
      result.volume += space::volume<double>(points_, filtration_.delaunay.simplices[t]);
    for (const std::uint32_t i : result.cells) {
      const auto& [a, b, c] = filtration_.triangles[i];
      const Vector normal = cross(edge(a, b), edge(a, c));
      result.area += std::hypot(normal.x, normal.y, normal.z) / 2;
    }
  }
  Vector edge(std::uint32_t a, std::uint32_t b) const { return space::from<double>(points_[a], points_[b]); }

  std::span<const Point3> points_;
  const SolidFiltration& filtration_;
  std::vector<bool> is_reached_;
};

void check(std::span<const Point3> points, const SolidFiltration& filtration, std::span<const SolidPair> pairs) {
  space::check_filtration("solid_representatives", points, filtration);
  const std::array<std::size_t, 4> counts = {points.size(), filtration.edges.size(), filtration.triangles.size(),
                                             filtration.triangles_of.size()};
  for (const SolidPair& pair : pairs) {
    const auto dimension = static_cast<std::size_t>(pair.dimension);
    meshops::require(dimension < 3 && pair.born_by < counts[dimension] &&
                         (pair.death ? pair.ended_by < counts[dimension + 1] : dimension == 0),
                     "solid_representatives: expected pairs of this filtration");
  }
}

}  // namespace

std::vector<SolidRepresentative> solid_representatives(std::span<const Point3> points,
                                                       const SolidFiltration& filtration,
                                                       std::span<const SolidPair> pairs, const GoOn& go_on) {
  check(points, filtration, pairs);
  Steps step(go_on);
  std::optional<space::Pairing> pairing;
  std::optional<space::Cycles> cycles;
  VoidSearch voids(points, filtration);
  const auto cycle_of = [&](const SolidPair& pair) {
    if (!cycles) {
      Threads one(1);
      pairing.emplace(filtration, one, go_on, step);
      cycles.emplace(points, filtration, *pairing, step);
    }
    meshops::require(pairing->tunnels.ended_by(pair.born_by) == pair.ended_by,
                     "solid_representatives: expected pairs of this filtration");
    space::Cycle cycle = cycles->of(pair.born_by);
    SolidRepresentative one;
    one.cells = std::move(cycle.edges);
    one.length = cycle.length;
    one.is_shortest = cycle.is_shortest;
    return one;
  };
  std::vector<SolidRepresentative> result;
  for (const SolidPair& pair : pairs) {
    step(64);
    if (pair.dimension == 1) {
      result.push_back(cycle_of(pair));
    } else if (pair.dimension == 2) {
      result.push_back(voids.of(pair.ended_by, pair.birth, static_cast<std::size_t>(&pair - pairs.data()), step));
    } else {
      result.emplace_back();
      if (!pair.death) continue;
      const auto& [a, b] = filtration.edges[pair.ended_by];
      result.back().cells = {pair.ended_by};
      result.back().length = space::distance(points[a], points[b]);
    }
  }
  return result;
}

}  // namespace rbpa
