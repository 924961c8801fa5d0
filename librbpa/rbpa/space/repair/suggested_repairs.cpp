#include "rbpa/space/repair/suggested_repairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/progress.h"
#include "rbpa/base/arrays/distinct.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/exact/least_reaching.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/surface/levels/add_level.h"
#include "rbpa/space/surface/levels/local_surface.h"
#include "rbpa/space/surface/levels/neighborhood_subset.h"
#include "rbpa/space/surface/levels/sub_surface.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_levels.h"

namespace rbpa {
namespace {

using Indices = std::vector<std::uint32_t>;

constexpr double ladder_ratio = 1.25;     // ratio of consecutive radii of larger balls
constexpr int steps = 12;                 // number of larger radii that are tried
constexpr double close_enough = 0x1p-10;  // relative distance to a failing radius at which bisection ends

Indices rim_of(const Hole& hole) {
  Indices rim;
  for (const RimEdge& edge : hole.edges) rim.push_back(edge.from);
  sort_unique(rim);
  return rim;
}

double diagonal_of(const Hole& hole, std::span<const Point3> points) {
  space::Box box;
  for (const RimEdge& edge : hole.edges) box.include(points[edge.from]);
  return std::hypot(box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z);
}

/// Tests whether a larger ball closes a hole.
class LargerBall {
 public:
  /// Keeps references. Requires: each radius passed to closes() is at most the radius of `near`.
  LargerBall(const space::LocalSurfaces& surfaces, const space::NeighborhoodFinder& near, std::uint32_t level)
      : surfaces_(surfaces), near_(near), level_(level) {}

  /// Returns the least radius at which the ball may rest on all triangles that close the hole, if the ball of `radius`
  /// closes the hole; otherwise nothing.
  std::optional<double> closes(const Hole& hole, double radius) const {
    constexpr std::size_t most_points = 4096;
    Indices wanted = rim_of(hole);
    while (wanted.size() <= most_points) {
      space::LocalSurface local = surfaces_.at(near_.around(wanted));
      std::vector<std::uint8_t> open(local.points.size(), 0);
      for (const std::uint32_t i : wanted) open[local.number_of(i)] = 1;
      space::add_level(local.points, local.normals, level_, radius, open, local.surface,
                       {.threads = 1, .progress = {}});
      const Spread spread = spread_from(hole, local, open);
      if (spread.is_open) return std::nullopt;
      if (spread.beyond.empty()) return least_radius_of(spread.added, local.points, radius);
      for (const std::uint32_t i : spread.beyond) wanted.push_back(local.input[i]);
      sort_unique(wanted);
    }
    return std::nullopt;
  }

 private:
  /// The triangles that the larger ball adds next to a hole.
  struct Spread {
    std::vector<Triangle> added;
    /// Corners around which there may be more triangles than are known. Empty if no triangle is missing.
    Indices beyond;
    bool is_open = false;  ///< whether an edge of the hole, or of an added triangle, is open
  };

  Spread spread_from(const Hole& hole, const space::LocalSurface& local, const std::vector<std::uint8_t>& known) const {
    const Surface& surface = local.surface;
    Spread spread;
    Indices waiting;
    std::vector<char> is_reached(surface.triangles.size(), 0);
    const auto cross = [&](std::uint32_t t, std::size_t side) {
      const std::uint32_t other = surface.neighbors[t][side];
      if (other == Surface::none) {
        spread.is_open = true;
      } else if (surface.levels[other] == level_ && is_reached[other] == 0) {
        is_reached[other] = 1;
        waiting.push_back(other);
      }
    };
    for (const RimEdge& edge : hole.edges) {
      const auto [t, side] = side_at(edge, local);
      cross(t, side);
    }
    while (!waiting.empty() && !spread.is_open) {
      const std::uint32_t t = waiting.back();
      waiting.pop_back();
      const Triangle& corners = surface.triangles[t];
      spread.added.push_back(corners);
      std::array<bool, 3> is_known{};
      for (std::size_t k = 0; k < 3; ++k) is_known[k] = known[corners[k]] != 0;
      for (std::size_t k = 0; k < 3; ++k) {
        if (!is_known[k]) spread.beyond.push_back(corners[k]);
        if (is_known[(k + 1) % 3] && is_known[(k + 2) % 3]) cross(t, k);
      }
    }
    return spread;
  }

  /// Returns the triangle of the local surface at a rim edge, and the side of the triangle at the edge.
  std::pair<std::uint32_t, std::size_t> side_at(const RimEdge& edge, const space::LocalSurface& local) const {
    Triangle corners = surfaces_.corners_of(edge.triangle);
    for (std::uint32_t& corner : corners) corner = local.number_of(corner);
    const std::uint32_t from = local.number_of(edge.from), to = local.number_of(edge.to);
    const auto& all = local.surface.triangles;
    const auto t = static_cast<std::uint32_t>(std::lower_bound(all.begin(), all.end(), corners) - all.begin());
    for (std::size_t k = 0; k < 3; ++k)
      if (corners[(k + 2) % 3] == from && corners[(k + 1) % 3] == to) return {t, k};
    throw meshops::ContractViolation(
        "suggested_repairs: a hole has an edge that is not a side of its triangle, expected holes() of this surface");
  }

  static double least_radius_of(const std::vector<Triangle>& triangles, const std::vector<Point3>& points,
                                double enough) {
    double radius = 0;
    for (const Triangle& t : triangles) {
      const auto reaches = [&](double r) {
        return space::exact::compare_circumradius(points[t[0]], points[t[1]], points[t[2]], r) <= 0;
      };
      if (radius == 0 || !reaches(radius)) radius = least_reaching_between(0, enough, reaches);
    }
    return radius;
  }

  const space::LocalSurfaces& surfaces_;
  const space::NeighborhoodFinder& near_;
  std::uint32_t level_;
};

class Repairs {
 public:
  Repairs(std::span<const Point3> points, std::span<const Point3> normals, std::span<const double> radii,
          const Surface& surface, std::span<const Hole> holes, const SurfaceOptions& options)
      : points_(points),
        normals_(normals),
        radii_(radii),
        surface_(surface),
        holes_(holes),
        options_(options),
        threads_(options.threads),
        go_on_(go_on_of(options.progress, points.size(), surface.triangles.size())),
        checkpoint_(go_on_),
        surfaces_(points, normals, surface),
        repairs_(holes.size()) {}

  std::vector<SuggestedRepair> run() {
    turn_normals();
    double radius = radii_.back();
    for (int step = 0; step < steps; ++step) roll(radius *= ladder_ratio);
    fill();
    return std::move(repairs_);
  }

 private:
  /// Calls attempt(hole, repair, near) for the wanted holes without a suggested repair. `near` finds the neighborhoods
  /// within the radius.
  template <typename IsWanted, typename Attempt>
  void for_each_left(double radius, const IsWanted& is_wanted, const Attempt& attempt) {
    Indices left;
    for (std::uint32_t i = 0; i < holes_.size(); ++i)
      if (repairs_[i].kind == SuggestedRepairKind::none && is_wanted(holes_[i])) left.push_back(i);
    if (left.empty()) return;
    const space::NeighborhoodFinder near(points_, radius);
    for_each_index(threads_, left.size(), [&](std::size_t k) {
      checkpoint_();
      attempt(holes_[left[k]], repairs_[left[k]], near);
    });
  }

  void turn_normals() {
    const auto is_wanted = [](const Hole& hole) {
      return std::any_of(hole.edges.begin(), hole.edges.end(),
                         [](const RimEdge& edge) { return edge.cause == RimCause::normals_disagree; });
    };
    const auto attempt = [&](const Hole& hole, SuggestedRepair& repair, const space::NeighborhoodFinder& near) {
      Indices turned;
      for (const RimEdge& edge : hole.edges)
        for (std::size_t k = 0; k < 3; ++k)
          if (edge.cause == RimCause::normals_disagree && edge.corners[k]) turned.push_back(edge.next[k]);
      sort_unique(turned);
      if (is_closed_with(turned, hole, near))
        repair = {.kind = SuggestedRepairKind::turn_normals, .points = std::move(turned)};
    };
    for_each_left(radii_.back(), is_wanted, attempt);
  }

  /// Returns whether reversing the normals of `turned` closes the hole. Adds to `turned` all points equal to one in it.
  bool is_closed_with(Indices& turned, const Hole& hole, const space::NeighborhoodFinder& near) const {
    Indices at = rim_of(hole);
    at.insert(at.end(), turned.begin(), turned.end());
    sort_unique(at);
    // The triangles that a radius adds at a point depend on the triangles of smaller radii at the points that the ball
    // touches from there. So each radius extends the changed part by one neighborhood. As many further neighborhoods
    // are needed to compute the changed part as in the whole surface.
    Indices changed = at, input;
    for (std::size_t i = 0; i < radii_.size(); ++i) changed = near.around(changed);
    input = changed;
    for (std::size_t i = 0; i < radii_.size(); ++i) input = near.around(input);
    space::LocalSurface local = surfaces_.at(input);
    const Surface before = std::move(local.surface);
    std::vector<char> is_turned(local.points.size(), 0), is_at(local.points.size(), 0);
    for (const std::uint32_t i : turned) is_turned[local.number_of(i)] = 1;
    for (const std::uint32_t i : changed) is_at[local.number_of(i)] = 1;
    for (const Duplicate& d : before.duplicates)
      if (is_turned[d.stands_for] != 0) {
        is_turned[d.index] = 1;
        turned.push_back(local.input[d.index]);
      }
    sort_unique(turned);
    for (std::size_t i = 0; i < local.points.size(); ++i) {
      Point3& n = local.normals[i];
      if (is_turned[i] != 0) n = {0.0 - n.x, 0.0 - n.y, 0.0 - n.z};
    }
    const Surface after = surface(local.points, local.normals, radii_, {.threads = 1, .progress = {}});

    // The hole is closed if its edges exist and are no boundary, and no other boundary is new.
    std::set<std::pair<std::uint32_t, std::uint32_t>> known, edges;
    for_each_side(before, is_at, [&](std::uint32_t from, std::uint32_t to, bool is_boundary) {
      if (is_boundary) known.insert({from, to});
    });
    for (const RimEdge& edge : hole.edges) known.erase({local.number_of(edge.from), local.number_of(edge.to)});
    bool is_new = false;
    for_each_side(after, is_at, [&](std::uint32_t from, std::uint32_t to, bool is_boundary) {
      if (is_boundary) is_new = is_new || !known.contains({from, to});
      edges.insert(std::minmax(from, to));
    });
    return !is_new && std::all_of(hole.edges.begin(), hole.edges.end(), [&](const RimEdge& edge) {
      return edges.contains(std::minmax(local.number_of(edge.from), local.number_of(edge.to)));
    });
  }

  /// Calls visit(from, to, is_boundary) for the sides with an end in `is_at`, directed like boundary curves.
  template <typename Visit>
  static void for_each_side(const Surface& surface, const std::vector<char>& is_at, const Visit& visit) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = surface.triangles[t][(k + 2) % 3], to = surface.triangles[t][(k + 1) % 3];
        if (is_at[from] != 0 || is_at[to] != 0) visit(from, to, surface.neighbors[t][k] == Surface::none);
      }
  }

  void roll(double radius) {
    if (!std::isfinite(radius)) return;
    const auto is_wanted = [&](const Hole& hole) {
      return radius <= std::max(ladder_ratio * radii_.back(), diagonal_of(hole, points_));
    };
    const auto attempt = [&](const Hole& hole, SuggestedRepair& repair, const space::NeighborhoodFinder& near) {
      const LargerBall ball(surfaces_, near, static_cast<std::uint32_t>(radii_.size()));
      const std::optional<double> least = ball.closes(hole, radius);
      if (!least) return;
      const double too_small = std::max(radii_.back(), radius / ladder_ratio);
      repair = {.kind = SuggestedRepairKind::larger_ball,
                .radius = least_closing(ball, hole, too_small, radius, *least)};
    };
    for_each_left(radius, is_wanted, attempt);
  }

  /// Returns the least radius found that closes the hole, at most `radius`, which closes it. First tries `least`, at
  /// which the ball may rest on all triangles that close the hole; if that ball contains another point, bisects.
  static double least_closing(const LargerBall& ball, const Hole& hole, double too_small, double radius, double least) {
    while (least < radius && radius > too_small * (1 + close_enough)) {
      const double smaller = least > too_small ? least : too_small + (radius - too_small) / 2;
      if (const auto found = ball.closes(hole, smaller)) {
        radius = smaller;
        least = *found;
      } else {
        too_small = smaller;
      }
    }
    return radius;
  }

  void fill() {
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < holes_.size(); ++i)
      if (repairs_[i].kind == SuggestedRepairKind::none) left.push_back(i);
    if (left.empty()) return;
    const Surface surface = indexable_surface(surface_, go_on_);
    const std::vector<Hole> curves = surface_curves(points_, surface, go_on_);
    const auto first = [](const Hole& hole) {
      const RimEdge& edge = hole.edges.front();
      return std::tuple(edge.from, edge.to, edge.triangle);
    };
    std::vector<Hole> wanted;
    std::erase_if(left, [&](std::uint32_t i) {
      const auto curve =
          std::lower_bound(curves.begin(), curves.end(), holes_[i],
                           [&](const Hole& hole, const Hole& other) { return first(hole) < first(other); });
      const bool is_there = curve != curves.end() && is_same(*curve, holes_[i]);
      if (is_there) wanted.push_back(*curve);
      return !is_there;
    });
    const FilledSurface filled = fill_holes(points_, surface, wanted, options_);
    for (std::size_t k = 0; k < left.size(); ++k) {
      SuggestedRepair& repair = repairs_[left[k]];
      repair.filled = filled.holes[k].outcome;
      if (*repair.filled == HoleOutcome::filled) repair.kind = SuggestedRepairKind::filling;
    }
  }

  static bool is_same(const Hole& curve, const Hole& hole) {
    return std::equal(curve.edges.begin(), curve.edges.end(), hole.edges.begin(), hole.edges.end(),
                      [](const RimEdge& e, const RimEdge& f) {
                        return e.from == f.from && e.to == f.to && e.triangle == f.triangle;
                      });
  }

  std::span<const Point3> points_, normals_;
  std::span<const double> radii_;
  const Surface& surface_;
  std::span<const Hole> holes_;
  const SurfaceOptions& options_;
  Threads threads_;
  GoOn go_on_;
  CheckpointOfThreads checkpoint_;
  space::LocalSurfaces surfaces_;
  std::vector<SuggestedRepair> repairs_;
};

}  // namespace

std::vector<SuggestedRepair> suggested_repairs(std::span<const Point3> points, std::span<const Point3> normals,
                                               std::span<const double> radii, const Surface& surface,
                                               std::span<const Hole> holes, const SurfaceOptions& options) {
  space::check_radii(radii);
  space::check_points(points);
  space::check_normals(points, normals);
  require_linked(space::arrays_of(surface), points.size());
  require_duplicates("suggested_repairs", surface.duplicates, points.size());
  for (const Hole& hole : holes) {
    const std::string name = "suggested_repairs: found hole " + std::to_string(&hole - holes.data());
    const char* const expected = ", expected the result of holes() for these points and this surface";
    if (hole.edges.empty()) throw meshops::ContractViolation(name + " without edges" + expected);
    for (const RimEdge& edge : hole.edges)
      if (edge.triangle >= surface.triangles.size() || edge.from >= points.size() || edge.to >= points.size())
        throw meshops::ContractViolation(name + " with point " + std::to_string(std::max(edge.from, edge.to)) +
                                         " or triangle " + std::to_string(edge.triangle) + ", which do not exist" +
                                         expected);
  }
  return Repairs(points, normals, radii, surface, holes, options).run();
}

}  // namespace rbpa
