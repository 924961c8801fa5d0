#include "rbpa/space/repair/fill_holes.h"

#include <cmath>
#include <mutex>
#include <optional>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "meshops/core/progress.h"
#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/crossing.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/repair/closing/bridges.h"
#include "rbpa/space/repair/closing/least_triangulation.h"
#include "rbpa/space/repair/closing/mesh_around.h"
#include "rbpa/space/repair/closing/simple_loops.h"
#include "rbpa/space/repair/closing/triangle_sides.h"
#include "rbpa/space/repair/closing/work.h"

namespace rbpa {
namespace {

using space::Chord;
using space::RimTriangle;
using space::SimpleLoop;

/// Returns the maximum number of further triangulations that are tried for a loop; more if a triangulation costs less.
std::size_t attempts_for(std::size_t corners) {
  constexpr std::size_t most = 100, least = 10, steps = 100'000'000;
  const std::size_t each = std::min(corners, std::size_t{300}) * std::min(corners, std::size_t{300}) * corners / 6 + 1;
  return std::clamp(steps / each, least, most);
}

/// Returns the maximum number of pairs of triangles that are compared.
std::size_t most_pairs(std::size_t triangles) {
  constexpr std::size_t always = std::size_t{1} << 24U, each = 4096;
  return always + each * triangles;
}

template <typename Value>
void add_sorted(std::vector<Value>& to, const std::vector<Value>& values) {
  to.insert(to.end(), values.begin(), values.end());
  sort_unique(to);
}

class Closing {
 public:
  Closing(std::span<const Point3> points, std::span<const Triangle> triangles,
          std::span<const std::vector<std::uint32_t>> loops, const space::BoundarySides& sides,
          const SurfaceOptions& options)
      : points_(points),
        go_on_([this, &options] {
          const std::lock_guard<std::mutex> lock(one_call_);
          return !options.progress || options.progress({made_, points_.size()});
        }),
        work_(most_pairs(triangles.size()), go_on_),
        loops_(space::simple_loops(points, loops, work_.steps())),
        around_(points, triangles, loops_, work_.steps()),
        vertices_(points.size()),
        threads_(loops_.size() < 2 ? 1 : options.threads) {
    for (const SimpleLoop& loop : loops_) {
      work_.steps()(loop.corners.size());
      std::vector<Point3> corners, across;
      for (const space::LoopCorner& corner : loop.corners) {
        corners.push_back(points[corner.in]);
        across.push_back(points[sides.across(loop.loop, corner.edge)]);
      }
      rims_.emplace_back(corners, across);
    }
    result_.triangles.assign(triangles.begin(), triangles.end());
    result_.loops.resize(loops.size());
    filled_.resize(loops_.size());
  }

  HoleFilling run() {
    // The best filling of each loop alone is found first. Then the loops are closed in a fixed order, because each
    // filling may obstruct the next one.
    std::vector<std::optional<space::RimFilling>> first(loops_.size());
    std::vector<std::vector<Chord>> taken(loops_.size());
    for_each_index(threads_, loops_.size(), [&](std::size_t i) {
      if (rims_[i].size() < 3) return;
      stop_if_cancelled(go_on_);
      meshops::Steps step(go_on_);
      taken[i] = around_.taken_chords(loops_[i]);
      first[i] = space::least_triangulation(rims_[i], space::candidate_chords(rims_[i], step), taken[i], {}, step);
    });
    for (std::uint32_t i = 0; i < loops_.size(); ++i) {
      stop_if_cancelled(go_on_);
      close(i, std::move(first[i]), std::move(taken[i]));
    }
    assemble();
    return std::move(result_);
  }

 private:
  void close(std::uint32_t i, std::optional<space::RimFilling> filling, std::vector<Chord> taken) {
    const space::Rim& rim = rims_[i];
    HoleFill& fill = result_.loops[loops_[i].loop];
    if (rim.size() < 3) return merge(loops_[i]);  // two edges between the same points
    std::vector<Chord> candidates, chords = taken;
    std::vector<RimTriangle> triangles;
    bool has_crossed = false;
    for (std::size_t left = attempts_for(rim.size()); filling; --left) {
      if (work_.is_over()) {
        fill.outcome = HoleOutcome::too_much_work;
        return;
      }
      const space::Faults faults = around_.faults(i, rim, filling->triangles, work_);
      if (faults.none()) return accept(i, *filling);
      has_crossed = has_crossed || !faults.crossing.empty() || !faults.triangles.empty();
      add_sorted(taken, faults.taken);
      add_sorted(chords, faults.taken);
      add_sorted(chords, faults.crossing);
      add_sorted(triangles, faults.triangles);
      if (left == 0) break;
      if (candidates.empty()) candidates = space::candidate_chords(rim, work_.steps());
      filling = space::least_triangulation(rim, candidates, chords, triangles, work_.steps());
    }
    if (fill.outcome != HoleOutcome::filled) return;  // an earlier part of the loop has set it
    fill.outcome = has_crossed ? HoleOutcome::crosses : !taken.empty() ? HoleOutcome::edge_taken : HoleOutcome::no_area;
  }

  void accept(std::uint32_t i, const space::RimFilling& filling) {
    around_.add(i, rims_[i], filling.triangles);
    HoleFill& fill = result_.loops[loops_[i].loop];
    fill.triangles += filling.triangles.size();
    fill.area += std::ldexp(filling.weight.area, 2 * rims_[i].exponent);
    filled_[i] = filling.triangles;
    made_ += filling.triangles.size();
    merge(loops_[i]);
  }
  void merge(const SimpleLoop& loop) {
    for (const space::LoopCorner& corner : loop.corners) vertices_.join(corner.in, corner.out);
  }

  /// Appends the new triangles, loop by loop, and replaces merged vertices in all triangles.
  void assemble() {
    std::vector<std::uint32_t> order(loops_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t i, std::uint32_t j) { return loops_[i].loop < loops_[j].loop; });
    for (const std::uint32_t i : order)
      for (const auto& [a, b, c] : filled_[i]) {
        const auto& corners = loops_[i].corners;
        result_.triangles.push_back({corners[a].in, corners[b].in, corners[c].in});
      }
    for (Triangle& t : result_.triangles)
      for (std::uint32_t& vertex : t) vertex = vertices_.find(vertex);
  }

  std::span<const Point3> points_;
  std::mutex one_call_;
  std::size_t made_ = 0;  // number of new triangles up to now
  GoOn go_on_;
  space::Work work_;
  std::vector<SimpleLoop> loops_;
  std::vector<space::Rim> rims_;
  space::MeshAround around_;
  meshops::DisjointSets vertices_;
  std::vector<std::vector<RimTriangle>> filled_;
  HoleFilling result_;
  Threads threads_;
};

/// Joins loops, in a second attempt. Loops that cannot be closed alone, because an island lies in the hole, are closed
/// together: strips of two triangles join them to one loop, which is closed like any other.
class Joining {
 public:
  using Loop = std::vector<std::uint32_t>;

  /// Keeps references to all arguments except `result`, the result of closing each loop alone.
  Joining(std::span<const Point3> points, std::span<const Loop> loops, const SurfaceOptions& options,
          HoleFilling result)
      : points_(points),
        loops_(loops),
        options_(options),
        result_(std::move(result)),
        go_on_(go_on_of(options.progress, points.size(), result_.triangles.size())),
        work_(most_pairs(result_.triangles.size()) / 16, go_on_) {}

  HoleFilling run() {
    std::vector<Open> open = open_loops();
    if (open.size() > 1) index();
    for (std::size_t i = 0; i + 1 < open.size() && left_ > 0; ++i) {
      if (!open[i].is_closed) close_with_others(open, i);
      for (std::size_t j = i; j < open.size() && work_.is_over(); ++j)
        if (!open[j].is_closed) result_.loops[open[j].number].outcome = HoleOutcome::too_much_work;
      if (work_.is_over()) break;
    }
    return std::move(result_);
  }

 private:
  struct Open {
    std::uint32_t number;
    space::Box box;
    std::vector<Point3> sorted;
    bool is_closed = false;
  };

  /// Returns the loops that stay open due to crossings, are still boundary, and visit no point twice; longest first.
  std::vector<Open> open_loops() {
    std::vector<Open> open;
    if (std::count_if(result_.loops.begin(), result_.loops.end(), crosses) < 2) return open;
    const std::vector<space::TriangleSide> sides = space::sorted_sides(result_.triangles, {}, work_.steps());
    for (std::uint32_t l = 0; l < loops_.size(); ++l) {
      work_.steps()(loops_[l].size());
      const Loop& loop = loops_[l];
      if (!crosses(result_.loops[l]) || !is_boundary(loop, sides)) continue;
      Open& of = open.emplace_back();
      of.number = l;
      for (const std::uint32_t v : loop) {
        of.sorted.push_back(points_[v]);
        of.box.include(points_[v]);
      }
      std::sort(of.sorted.begin(), of.sorted.end());
      if (std::adjacent_find(of.sorted.begin(), of.sorted.end()) != of.sorted.end()) open.pop_back();
    }
    std::sort(open.begin(), open.end(), [](const Open& a, const Open& b) {
      return a.sorted.size() != b.sorted.size() ? a.sorted.size() > b.sorted.size() : a.sorted < b.sorted;
    });
    return open;
  }

  /// Returns whether a loop is still a boundary of the current triangles: closing other loops may have merged vertices.
  static bool is_boundary(const Loop& loop, const std::vector<space::TriangleSide>& sides) {
    const auto has = [&](std::uint32_t from, std::uint32_t to) {
      const auto found =
          std::lower_bound(sides.begin(), sides.end(), std::pair(from, to),
                           [](const space::TriangleSide& s, const auto& key) { return std::pair(s.from, s.to) < key; });
      return found != sides.end() && found->from == from && found->to == to;
    };
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t from = loop[i], to = loop[(i + 1) % loop.size()];
      if (has(from, to) || !has(to, from)) return false;
    }
    return true;
  }

  static bool crosses(const HoleFill& fill) { return fill.outcome == HoleOutcome::crosses && fill.triangles == 0; }

  /// Joins near open loops to loop number `first`, one after the other, until the joined loop can be closed.
  void close_with_others(std::vector<Open>& open, std::size_t first) {
    Loop joined = loops_[open[first].number];
    space::Box box = open[first].box;
    std::vector<std::size_t> members = {first};
    std::vector<Triangle> strips;
    for (std::size_t j = 0; j < open.size() && left_ > 0 && !work_.is_over(); ++j) {
      work_();
      if (j == first || open[j].is_closed || !open[j].box.meets(box)) continue;
      const Loop& other = loops_[open[j].number];
      const std::optional<space::Bridge> bridge = free_bridge(joined, other);
      if (!bridge) continue;
      for (const Triangle& t : space::strip_of(*bridge, joined, other)) strips.push_back(t);
      joined = space::joined_loop(*bridge, joined, other);
      box.include(open[j].box);
      members.push_back(j);
      if (!close(joined, strips, open[first].number)) continue;
      for (const std::size_t member : members) {
        open[member].is_closed = true;
        result_.loops[open[member].number].outcome = HoleOutcome::filled;
      }
      return;
    }
  }

  /// Returns the best bridge whose triangles cross no existing triangle.
  std::optional<space::Bridge> free_bridge(const Loop& loop, const Loop& other) {
    constexpr std::size_t most = 8;
    for (const space::Bridge& bridge : space::nearest_bridges(points_, loop, other, most, work_)) {
      const auto strip = space::strip_of(bridge, loop, other);
      if (std::none_of(strip.begin(), strip.end(), [&](const Triangle& t) { return is_in_the_way(t); })) return bridge;
    }
    return std::nullopt;
  }

  /// Indexes the current triangles that have an area.
  void index() {
    triangles_.clear();
    std::vector<space::Box> boxes;
    for (const Triangle& t : result_.triangles) {
      work_.steps()();
      const space::Corners corners = corners_of(t);
      if (space::are_collinear(corners[0], corners[1], corners[2])) continue;
      triangles_.push_back(corners);
      boxes.push_back(space::box_of(corners));
    }
    tree_ = space::BoxTree(boxes, work_.steps());
  }

  /// Returns whether a triangle crosses an existing one or has no area. Counts all near triangles as work, also after a
  /// crossing is found, so that the count does not depend on the order of the triangles.
  bool is_in_the_way(const Triangle& triangle) {
    const space::Corners own = corners_of(triangle);
    if (space::are_collinear(own[0], own[1], own[2])) return true;
    bool found = false;
    tree_.for_each_meeting(space::box_of(own), [&](std::uint32_t t) {
      work_();
      found = found || space::triangles_cross(own, triangles_[t]);
    });
    return found;
  }

  space::Corners corners_of(const Triangle& t) const { return {points_[t[0]], points_[t[1]], points_[t[2]]}; }

  bool close(const Loop& joined, const std::vector<Triangle>& strips, std::uint32_t number) {
    --left_;
    std::vector<Triangle> with_strips = result_.triangles;
    with_strips.insert(with_strips.end(), strips.begin(), strips.end());
    if (has_common_side(with_strips)) return false;
    const std::vector<Loop> loop = {joined};
    const space::BoundarySides sides(with_strips, loop, work_.steps());
    HoleFilling filling = Closing(points_, with_strips, loop, sides, options_).run();
    if (filling.loops.front().outcome != HoleOutcome::filled) return false;
    HoleFill& fill = result_.loops[number];
    fill.triangles = strips.size() + filling.loops.front().triangles;
    fill.area = filling.loops.front().area + area_of(strips);
    result_.triangles = std::move(filling.triangles);
    index();
    return true;
  }

  /// Returns whether two triangles have a side between the same vertices in the same direction.
  bool has_common_side(std::span<const Triangle> triangles) {
    const std::vector<space::TriangleSide> sides = space::sorted_sides(triangles, {}, work_.steps());
    return std::adjacent_find(sides.begin(), sides.end(), [](const auto& s, const auto& t) {
             return s.from == t.from && s.to == t.to;
           }) != sides.end();
  }

  double area_of(const std::vector<Triangle>& triangles) const {
    double sum = 0;
    for (const Triangle& t : triangles) {
      const space::Corners corners = corners_of(t);
      const space::Rim rim(corners, corners);  // with places scaled to a box of side 1
      const auto n = cross(rim.places[1] - rim.places[0], rim.places[2] - rim.places[0]);
      sum += std::ldexp(std::sqrt(dot(n, n)) / 2, 2 * rim.exponent);
    }
    return sum;
  }

  std::span<const Point3> points_;
  std::span<const Loop> loops_;
  const SurfaceOptions& options_;
  HoleFilling result_;
  GoOn go_on_;
  space::Work work_;
  std::vector<space::Corners> triangles_;
  space::BoxTree tree_;
  int left_ = 16;  // attempts that are left
};

}  // namespace

std::vector<std::vector<std::uint32_t>> boundary_loops(std::span<const Triangle> triangles) {
  const GoOn never;
  meshops::Steps step(never);
  return space::loops_of(triangles, step);
}

HoleFilling fill_holes(std::span<const Point3> points, std::span<const Triangle> triangles,
                       std::span<const std::vector<std::uint32_t>> loops, const SurfaceOptions& options) {
  space::check_points(points);
  for (const Triangle& t : triangles)
    for (const std::uint32_t vertex : t)
      meshops::require(vertex < points.size(), "fill_holes: found corner ", vertex,
                       " of a triangle, expected the index of a point");
  const GoOn go_on = go_on_of(options.progress, points.size(), triangles.size());
  meshops::Steps step(go_on);
  const space::BoundarySides sides(triangles, loops, step);
  return Joining(points, loops, options, Closing(points, triangles, loops, sides, options).run()).run();
}

}  // namespace rbpa
