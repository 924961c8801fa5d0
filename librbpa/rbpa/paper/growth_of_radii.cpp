#include "rbpa/paper/growth_of_radii.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "meshops/front/engine.h"
#include "rbpa/paper/point_quadtree.h"

namespace rbpa::paper {
namespace {

/// The radii α₀, 2α₀, 4α₀ … below α, followed by α.
class Radii {
 public:
  /// Computes the radii. If α = ∞, only the radii below `largest` precede α.
  Radii(double minimal, Radius alpha, Real largest) : minimal_(minimal), alpha_(alpha) {
    const Real end =
        alpha.is_infinite() ? std::min(largest, Real(std::numeric_limits<double>::max())) : Real(alpha.value());
    while (std::ldexp(Real(minimal), last_) < end) ++last_;
  }
  int last() const { return last_; }
  Radius operator[](int i) const { return i == last_ ? alpha_ : Radius(std::ldexp(minimal_, i)); }

 private:
  double minimal_;
  Radius alpha_;
  int last_ = 0;
};

/// A policy that sets `found` if `rbpa` has a triangle to insert, but inserts no triangle.
struct Look {
  RestrictedBallPivoting& rbpa;
  bool found = false;

  std::optional<Triangle> seed(const Front& front) {
    found = found || rbpa.seed(front);
    return std::nullopt;
  }
  std::optional<Site> propose(const Front& front, Halfedge h) {
    found = found || rbpa.propose(front, h);
    return std::nullopt;
  }
};

class Run {
 public:
  Run(std::span<const Point> points, const Radii& radii, Front& front, Monitor& monitor,
      const std::function<void(const Level&)>& level_ended)
      : points_(points), radii_(radii), front_(front), monitor_(monitor), level_ended_(level_ended) {}

  /// Runs all levels: section 6, "Summarizing HRBPA", steps 2 to 4.
  void all_levels() {
    for (int i = 0;;) {
      // 2. Transfer boundary and isolated points as input.
      RestrictedBallPivoting rbpa = input_of(i);
      // 3. Apply RBPA with radius αᵢ. If αᵢ ≥ α, apply RBPA with radius α instead, and stop.
      const std::size_t before = front_.faces();
      meshops::advance(front_, rbpa, monitor_);
      level_ended_(level_);
      if (level_.is_last) return;
      // 4. Set i = i + 1, αᵢ = 2αᵢ₋₁; if no triangle is added, continue with the next level that adds one.
      i = front_.faces() > before ? i + 1 : next_with_a_triangle(i);
    }
  }

 private:
  /// Moves the front to level i and returns RBPA on the points transferred to this level. At level 0, all points are
  /// isolated.
  RestrictedBallPivoting input_of(int i) {
    meshops::LevelTransfer transfer = front_.next_level();
    level_ = {i, radii_[i], i == radii_.last(), transfer.carried.size(), transfer.reactivated};
    return {points_, std::move(transfer.carried), level_.radius, [&](const Front& seen) { monitor_.searched(seen); }};
  }

  /// Returns the first level above `none` with a triangle to insert; the last level if no level before has one. Tests
  /// levels at distances that first double, then halve. Requires: no level up to `none` has a triangle to insert.
  int next_with_a_triangle(int none) {
    int some = radii_.last();
    for (int step = 1; none + step < some; step *= 2) {
      if (has_a_triangle(none + step))
        some = none + step;
      else
        none += step;
    }
    while (some - none > 1) {
      const int middle = std::midpoint(none, some);
      (has_a_triangle(middle) ? some : none) = middle;
    }
    return some;
  }

  bool has_a_triangle(int i) {
    RestrictedBallPivoting rbpa = input_of(i);
    Look look{rbpa};
    meshops::advance(front_, look);
    if (!look.found) level_ended_(level_);
    return look.found;
  }

  std::span<const Point> points_;
  const Radii& radii_;
  Front& front_;
  Monitor& monitor_;
  const std::function<void(const Level&)>& level_ended_;
  Level level_{};
};

}  // namespace

double hrbpa(std::span<const Point> points, Radius alpha, std::size_t leaf_capacity, Front& front, Monitor& monitor,
             const std::function<void(const Level&)>& level_ended) {
  // 1. Compute the minimal radius α₀, set αᵢ = α₀ and i = 0.
  const double minimal = minimal_radius(quadtree(points, leaf_capacity));
  const Box box = paper::box_of(points);
  const Radii radii(minimal, alpha, 2 * (box.width + box.height));
  Run(points, radii, front, monitor, level_ended).all_levels();
  return minimal;
}

}  // namespace rbpa::paper
