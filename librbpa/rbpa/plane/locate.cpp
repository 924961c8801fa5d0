#include "rbpa/locate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/base/input.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {
namespace {

/// As many triangles as a triangulation of all these points up to their convex hull has, by Euler's formula.
bool is_triangulation_of_all(std::size_t points, const TriangleArrays& of) {
  std::size_t sides = 0;
  for (const auto& neighbors : of.neighbors)
    sides += static_cast<std::size_t>(std::count(neighbors.begin(), neighbors.end(), no_index));
  return of.triangles.size() + sides + 2 == 2 * points;
}

std::function<void()> asking(const std::function<bool()>& go_on) {
  if (!go_on) return {};
  return [&go_on] {
    if (!go_on()) throw Cancelled();
  };
}

}  // namespace

class Locator::Impl {
 public:
  Impl(std::span<const Point> points, const TriangleArrays& delaunay, Threads& threads,
       const std::function<void()>& ask)
      : points_(points), of_(delaunay), sites_(points, threads, ask), at_site_(sites_.size(), 0) {
    if (of_.triangles.empty()) return;
    meshops::require(is_triangulation_of_all(sites_.size(), of_),
                     "locator: the triangles are not all of the Delaunay triangulation of the points");
    std::vector<std::uint32_t> at_point(points.size(), 0);
    for (std::uint32_t t = 0; t < of_.triangles.size(); ++t)
      for (const std::uint32_t corner : of_.triangles[t]) at_point[corner] = t;
    for (std::size_t s = 0; s < at_site_.size(); ++s) at_site_[s] = at_point[sites_.input_index()[s]];
  }

  std::uint32_t find(const Point& query) const {
    if (of_.triangles.empty() || !is_finite(query)) return no_index;
    std::uint32_t at = first_near(query);
    for (std::size_t steps = 0; steps <= of_.triangles.size(); ++steps) {
      std::array<int, 3> sign;
      std::size_t k = 0;
      for (; k < 3; ++k) {
        sign[k] = side(at, k, query);
        if (sign[k] < 0) break;
      }
      if (k == 3) return first_that_has(at, sign);
      at = of_.neighbors[at][k];
      if (at == no_index) return no_index;  // beyond the convex hull
    }
    throw meshops::ContractViolation("locator: a walk goes round in circles, so the triangulation is not Delaunay");
  }

 private:
  /// On which side of the side across from corner k: 1 for inside, 0 for on its line.
  int side(std::uint32_t t, std::size_t k, const Point& query) const {
    const auto& corners = of_.triangles[t];
    return Predicates<long double>::orientation(points_[corners[(k + 1) % 3]], points_[corners[(k + 2) % 3]], query);
  }

  /// A triangle at a point in the cell of the query, or in one near it: any will do.
  std::uint32_t first_near(const Point& query) const {
    const PointGrid& grid = sites_.grid();
    if (grid.points().empty()) return 0;
    const Point scaled{std::ldexp(query.x, sites_.window().exponent), std::ldexp(query.y, sites_.window().exponent)};
    const PointGrid::Level* level = &grid.levels()[0];
    while (true) {
      const std::uint32_t cell = level->cell_of(scaled);
      const auto child = level->child_at(cell);
      if (child == level->children.end() || child->cell != cell) {
        const std::size_t site = std::min<std::size_t>(level->start[cell], grid.points().size() - 1);
        return at_site_[site];
      }
      level = &grid.levels()[child->level];
    }
  }

  /// Of the triangles that have the point for which side() returns `sign`, the first.
  std::uint32_t first_that_has(std::uint32_t t, const std::array<int, 3>& sign) const {
    const auto zeros = std::count(sign.begin(), sign.end(), 0);
    if (zeros == 0) return t;
    if (zeros == 1) {
      const auto k = static_cast<std::size_t>(std::find(sign.begin(), sign.end(), 0) - sign.begin());
      return std::min(t, of_.neighbors[t][k]);  // none is the largest number
    }
    // On two sides: at the corner that they share, which is across from the third.
    const auto k = static_cast<std::size_t>(std::find(sign.begin(), sign.end(), 1) - sign.begin());
    const std::uint32_t corner = of_.triangles[t][k];
    return std::min(first_around(t, corner, 1), first_around(t, corner, 2));
  }

  /// The least triangle at the corner from t on, in one direction: 1 or 2, which is the side that is crossed, counted from
  /// the corner.
  std::uint32_t first_around(std::uint32_t t, std::uint32_t corner, std::size_t direction) const {
    std::uint32_t least = t, at = t;
    do {
      const auto& corners = of_.triangles[at];
      const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), corner) - corners.begin());
      at = of_.neighbors[at][(k + direction) % 3];
      least = std::min(least, at);
    } while (at != t && at != no_index);
    return least;
  }

  std::span<const Point> points_;
  TriangleArrays of_;
  Sites sites_;
  std::vector<std::uint32_t> at_site_;  // of each site, a triangle that it is a corner of
};

Locator::Locator(std::span<const Point> points, const TriangleArrays& delaunay, const LocateOptions& options) {
  check(points, 1);
  require_linked(delaunay, points.size(), options.go_on);
  Threads threads = threads_for(points.size(), options.threads);
  impl_ = std::make_unique<const Impl>(points, delaunay, threads, asking(options.go_on));
}
Locator::Locator(Locator&&) noexcept = default;
Locator& Locator::operator=(Locator&&) noexcept = default;
Locator::~Locator() = default;

std::vector<std::uint32_t> Locator::find(std::span<const Point> queries, const LocateOptions& options) const {
  constexpr std::size_t queries_at_a_time = 4096;
  std::vector<std::uint32_t> found(queries.size());
  Threads threads = threads_for(queries.size(), options.threads);
  std::mutex calling;
  for_each_part(threads, queries.size(), queries_at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) found[i] = impl_->find(queries[i]);
    if (!options.go_on) return;
    const std::lock_guard lock(calling);
    if (!options.go_on()) throw Cancelled();
  });
  return found;
}

}  // namespace rbpa
