#include "rbpa/plane/locate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/base/exact/double_double.h"
#include "rbpa/base/exact/hypotenuse.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/run/input.h"
#include "rbpa/plane/arrays/natural_neighbors.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/plane/predicate/radius.h"

namespace rbpa {
namespace {

/// Returns whether there are as many triangles as a triangulation of all these points up to their convex hull has, by
/// Euler's formula.
bool is_triangulation_of_all(std::size_t points, const TriangleArrays& of) {
  std::size_t sides = 0;
  for (const auto& neighbors : of.neighbors)
    sides += static_cast<std::size_t>(std::count(neighbors.begin(), neighbors.end(), no_index));
  return of.triangles.size() + sides + 2 == 2 * points;
}

/// Returns 1 if the query is inside of the line across from corner k of a triangle, 0 if on the line, −1 if outside.
int side_of(const std::array<Point, 3>& corners, std::size_t k, const Point& query) {
  return Predicates<long double>::orientation(corners[(k + 1) % 3], corners[(k + 2) % 3], query);
}

/// The corners of a triangle relative to a query in the triangle, halved if differences would overflow.
struct SeenFrom {
  std::array<Point, 3> at;
  std::array<double, 3> size;  // the larger of |x| and |y|

  SeenFrom(const std::array<Point, 3>& corners, const Point& query) {
    const auto see = [&](double scale) {
      for (std::size_t k = 0; k < 3; ++k) {
        at[k] = {scale * corners[k].x - scale * query.x, scale * corners[k].y - scale * query.y};
        size[k] = std::max(std::abs(at[k].x), std::abs(at[k].y));
      }
    };
    see(1);
    if (std::isinf(largest())) see(0.5);
  }
  double largest() const { return std::max({size[0], size[1], size[2]}); }
  double least() const { return std::min({size[0], size[1], size[2]}); }
};

using Areas = std::array<double, 3>;

/// Returns for each corner the area across from the corner: cross(i, j) of the two other corners, or 0 if the cross
/// product is negative.
template <typename Cross>
Areas areas(Cross cross) {
  return {std::max(0.0, cross(1, 2)), std::max(0.0, cross(2, 0)), std::max(0.0, cross(0, 1))};
}

/// Returns the areas, up to a common factor, where products would overflow or underflow: each corner is scaled to about
/// size one by an exponent of its own.
Areas areas_of_any_size(const SeenFrom& seen) {
  std::array<int, 3> exponent;
  for (std::size_t k = 0; k < 3; ++k) exponent[k] = std::ilogb(seen.size[k]);
  const auto unit = [&](std::size_t k) {
    return Point{std::scalbn(seen.at[k].x, -exponent[k]), std::scalbn(seen.at[k].y, -exponent[k])};
  };
  Areas area = areas([&](std::size_t i, std::size_t j) {
    const Point a = unit(i), b = unit(j);
    return a.x * b.y - a.y * b.x;
  });
  // The area across from a corner does not depend on that corner's exponent.
  const int least = std::min({exponent[0], exponent[1], exponent[2]});
  for (std::size_t k = 0; k < 3; ++k) area[k] = std::scalbn(area[k], least - exponent[k]);
  return area;
}

/// Returns the shares of the ends of a side at a query on the side, which is across from corner `across`.
Areas shares_on_side(const SeenFrom& seen, std::size_t across) {
  const std::size_t a = (across + 1) % 3, b = (across + 2) % 3;
  Areas share = {0, 0, 0};
  share[a] = seen.size[b] / (seen.size[a] + seen.size[b]);
  share[b] = seen.size[a] / (seen.size[a] + seen.size[b]);
  return share;
}

/// Returns the barycentric coordinates of a query in a triangle: ratios of areas, not negative, with sum 1.
Areas shares(const std::array<Point, 3>& corners, const Point& query) {
  const SeenFrom seen(corners, query);
  if (seen.least() == 0) return {double(seen.size[0] == 0), double(seen.size[1] == 0), double(seen.size[2] == 0)};
  for (std::size_t k = 0; k < 3; ++k)
    if (side_of(corners, k, query) == 0) return shares_on_side(seen, k);
  const bool is_of_any_size = seen.least() < 0x1p-400 || seen.largest() > 0x1p400;
  const auto sum = [](const Areas& area) { return area[0] + area[1] + area[2]; };
  Areas area = is_of_any_size ? areas_of_any_size(seen) : areas([&](std::size_t i, std::size_t j) {
    return seen.at[i].x * seen.at[j].y - seen.at[i].y * seen.at[j].x;
  });
  // If a triangle is thin compared with its length, rounding of differences may hide the area.
  if (!is_of_any_size && sum(area) < 0x1p-20 * seen.largest() * seen.largest())
    area = areas([&](std::size_t i, std::size_t j) {
      const auto x = [&](std::size_t k) { return DoubleDouble::difference(corners[k].x, query.x); };
      const auto y = [&](std::size_t k) { return DoubleDouble::difference(corners[k].y, query.y); };
      return (x(i) * y(j) - y(i) * x(j)).high;
    });
  if (const double whole = sum(area); whole > 0) return {area[0] / whole, area[1] / whole, area[2] / whole};
  // If no area is left, interpolates between the two corners that are farthest apart.
  std::size_t third = 0;
  double longest = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = seen.at[(k + 1) % 3], &b = seen.at[(k + 2) % 3];
    const double length = hypotenuse(b.x / 2 - a.x / 2, b.y / 2 - a.y / 2);
    if (length <= longest) continue;
    longest = length;
    third = k;
  }
  return shares_on_side(seen, third);
}

}  // namespace

class Locator::Impl {
 public:
  Impl(std::span<const Point> points, const TriangleArrays& delaunay, Threads& threads, const Checkpoint& checkpoint)
      : points_(points), of_(delaunay), sites_(points, threads, checkpoint), at_site_(sites_.size(), 0) {
    if (of_.triangles.empty()) return;
    meshops::require(is_triangulation_of_all(sites_.size(), of_),
                     "locator: the triangles are not the whole Delaunay triangulation of the points (take "
                     "alpha_complex(points, infinity))");
    std::vector<std::uint32_t> at_point(points.size(), 0);
    for (std::uint32_t t = 0; t < of_.triangles.size(); ++t)
      for (const std::uint32_t corner : of_.triangles[t]) at_point[corner] = t;
    for (std::size_t s = 0; s < at_site_.size(); ++s) at_site_[s] = at_point[sites_.input_index()[s]];
  }

  /// Returns the triangle that contains the query, as Locator::find(). `last` is the triangle of an earlier query, or
  /// none: consecutive queries are often near each other.
  std::uint32_t find(const Point& query, std::uint32_t last) const {
    if (of_.triangles.empty() || !is_finite(query)) return no_index;
    std::uint32_t at = last != no_index && is_near(last, query) ? last : first_near(query);
    std::minstd_rand random;
    for (std::size_t steps = 0; steps <= patience + 64 * of_.triangles.size(); ++steps) {
      std::array<int, 3> sign;
      std::size_t k = steps < patience ? 0 : random() % 3, tried = 0;
      for (; tried < 3; ++tried, k = (k + 1) % 3) {
        sign[k] = side(at, k, query);
        if (sign[k] < 0) break;
      }
      if (tried == 3) {
        std::uint32_t first = at;
        visit_all_with(at, sign, [&](std::uint32_t t) { first = std::min(first, t); });
        return first;
      }
      at = of_.neighbors[at][k];
      if (at == no_index) return no_index;  // beyond the convex hull
    }
    throw meshops::ContractViolation(
        "locator: found triangles that do not lie side by side, expected a triangulation of the points");
  }

  /// Returns whether a triangle of circumradius ≤ alpha contains the query. Requires: triangle t contains the query.
  bool covers(const Radius& alpha, std::uint32_t t, const Point& query) const {
    const auto admits = [&](std::uint32_t of) {
      const auto [a, b, c] = corners_of(of);
      return alpha.admits<long double>(a, b, c);
    };
    if (admits(t)) return true;
    bool any = false;
    visit_all_with(t, {side(t, 0, query), side(t, 1, query), side(t, 2, query)},
                   [&](std::uint32_t other) { any = any || admits(other); });
    return any;
  }

  std::size_t points() const { return points_.size(); }
  bool is_constrained() const { return of_.is_constrained; }

  NaturalNeighbors natural_neighbors() const { return {points_, of_}; }

  /// Writes to `result` the value of each column at a query in triangle t, NaNs if t is none. Uses natural neighbors
  /// unless `neighbors` is null.
  void interpolate(std::uint32_t t, std::span<const double> values, const Point& query, NaturalNeighbors* neighbors,
                   std::span<double> result) const {
    if (t == no_index) {
      std::fill(result.begin(), result.end(), std::numeric_limits<double>::quiet_NaN());
      return;
    }
    std::array<PointShare, 3> linear;
    std::span<const PointShare> mixed = linear;
    if (neighbors != nullptr && is_within(t, query)) {
      mixed = neighbors->find(query, t);
    } else {
      const Triangle corners = least_first(points_, of_.triangles[t]);
      const Areas share = shares({points_[corners[0]], points_[corners[1]], points_[corners[2]]}, query);
      for (std::size_t k = 0; k < 3; ++k) linear[k] = {corners[k], share[k]};
    }
    for (std::size_t column = 0; column < result.size(); ++column) {
      double sum = 0, least = std::numeric_limits<double>::infinity(), greatest = -least;
      for (const PointShare& of : mixed) {
        if (!(of.share > 0)) continue;  // a value without a share does not count, even if it is infinite
        const double value = values[of.point * result.size() + column];
        sum += of.share * value;
        least = std::min(least, value);
        greatest = std::max(greatest, value);
      }
      result[column] = std::min(std::max(sum, least), greatest);  // shares have the sum 1 up to rounding; keeps NaN
    }
  }

 private:
  /// Steps after which a walk tries the sides of a triangle in random order. Among constrained triangles, a walk that
  /// tries them in one order may go around for ever; in random order it ends.
  static constexpr std::size_t patience = 1000;

  std::array<Point, 3> corners_of(std::uint32_t t) const {
    const auto& [a, b, c] = of_.triangles[t];
    return {points_[a], points_[b], points_[c]};
  }

  /// Returns side_of() for triangle t.
  int side(std::uint32_t t, std::size_t k, const Point& query) const { return side_of(corners_of(t), k, query); }

  /// Returns whether the query, which is in triangle t, is no corner of t and not on the convex hull.
  bool is_within(std::uint32_t t, const Point& query) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (points_[of_.triangles[t][k]] == query) return false;
      if (of_.neighbors[t][k] == no_index && side(t, k, query) == 0) return false;
    }
    return true;
  }

  /// Returns whether, in the maximum norm, the query is at most twice as far from the first corner of triangle t as
  /// another corner is: then few steps lead to the query.
  bool is_near(std::uint32_t t, const Point& query) const {
    const auto& corners = of_.triangles[t];
    const auto distance = [&](const Point& p) {
      const Point& q = points_[corners[0]];
      return std::max(std::abs(p.x - q.x), std::abs(p.y - q.y));
    };
    return distance(query) <= 2 * std::max(distance(points_[corners[1]]), distance(points_[corners[2]]));
  }

  /// Returns a triangle with a corner in the cell of the query or near that cell.
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

  /// Calls visit() for each of the triangles that contain a point of triangle t, some of them twice; sign[k] is side(t,
  /// k) of the point.
  template <typename Visit>
  void visit_all_with(std::uint32_t t, const std::array<int, 3>& sign, Visit visit) const {
    visit(t);
    const auto zeros = std::count(sign.begin(), sign.end(), 0);
    if (zeros == 1) {
      const auto k = static_cast<std::size_t>(std::find(sign.begin(), sign.end(), 0) - sign.begin());
      if (of_.neighbors[t][k] != no_index) visit(of_.neighbors[t][k]);
    }
    if (zeros < 2) return;
    // The point is on two sides, so it is the corner that both sides share, across from the third side.
    const auto k = static_cast<std::size_t>(std::find(sign.begin(), sign.end(), 1) - sign.begin());
    const std::uint32_t corner = of_.triangles[t][k];
    for (const std::size_t direction : {1U, 2U}) visit_around(t, corner, direction, visit);
  }

  /// Calls visit() for the triangles around `corner`, from the one after t on in one direction: 1 crosses the side
  /// across from the next corner, 2 the side across from the corner after that.
  template <typename Visit>
  void visit_around(std::uint32_t t, std::uint32_t corner, std::size_t direction, Visit visit) const {
    std::uint32_t at = t;
    do {
      const auto& corners = of_.triangles[at];
      const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), corner) - corners.begin());
      at = of_.neighbors[at][(k + direction) % 3];
      if (at != no_index) visit(at);
    } while (at != t && at != no_index);
  }

  std::span<const Point> points_;
  TriangleArrays of_;
  Sites sites_;
  std::vector<std::uint32_t> at_site_;  // for each site, a triangle with a corner there
};

Locator::Locator(std::span<const Point> points, const TriangleArrays& delaunay, const LocateOptions& options) {
  check(points, 1);
  require_linked(delaunay, points.size(), options.go_on);
  Threads threads = threads_for(points.size(), options.threads);
  impl_ = std::make_unique<const Impl>(points, delaunay, threads, checkpoint_of(options.go_on));
}
Locator::Locator(Locator&&) noexcept = default;
Locator& Locator::operator=(Locator&&) noexcept = default;
Locator::~Locator() = default;

namespace {

/// Calls visit(i, last) for each query i. Threads share the queries in parts; begin() returns the `visit` of a part,
/// and go_on() is called after each part. `last` is the result for the query before, or none.
template <typename Begin>
void for_each_query(std::size_t queries, unsigned most_threads, const GoOn& go_on, Begin begin) {
  constexpr std::size_t queries_at_a_time = 4096;
  Threads threads = threads_for(queries, most_threads);
  CheckpointOfThreads checkpoint(go_on);
  for_each_part(threads, queries, queries_at_a_time, [&](std::size_t first, std::size_t last) {
    auto visit = begin();
    std::uint32_t found = no_index;
    for (std::size_t i = first; i < last; ++i) found = visit(i, found);
    checkpoint();
  });
}

}  // namespace

std::vector<std::uint32_t> Locator::find(std::span<const Point> queries, const LocateOptions& options) const {
  std::vector<std::uint32_t> found(queries.size());
  for_each_query(queries.size(), options.threads, options.go_on, [&] {
    return [&](std::size_t i, std::uint32_t last) { return found[i] = impl_->find(queries[i], last); };
  });
  return found;
}

std::vector<double> Locator::interpolate(std::span<const double> values, std::size_t columns,
                                         std::span<const Point> queries, const InterpolateOptions& options) const {
  if (columns == 0 || values.size() / columns != impl_->points() || values.size() % columns != 0)
    throw InvalidInput("values: found " + std::to_string(values.size()) + " numbers, expected " +
                       std::to_string(columns) + " for each of the " + std::to_string(impl_->points()) + " points");
  if (!(options.alpha > 0)) throw InvalidInput("alpha: found " + text(options.alpha) + ", expected a radius above 0");
  const bool is_natural = options.method == Interpolation::natural_neighbor;
  if (is_natural && impl_->is_constrained())
    throw InvalidInput("method: found \"natural\", expected \"linear\", as segments bound neighbors");
  const Radius alpha = Radius::of(options.alpha);
  std::vector<double> result(queries.size() * columns);
  for_each_query(queries.size(), options.threads, options.go_on, [&] {
    return [&, neighbors = impl_->natural_neighbors()](std::size_t i, std::uint32_t last) mutable {
      const std::uint32_t t = impl_->find(queries[i], last);
      const bool is_covered = t != no_index && impl_->covers(alpha, t, queries[i]);
      impl_->interpolate(is_covered ? t : no_index, values, queries[i], is_natural ? &neighbors : nullptr,
                         std::span(result).subspan(i * columns, columns));
      return t;
    };
  });
  return result;
}

}  // namespace rbpa
