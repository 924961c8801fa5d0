#include "rbpa/fill_holes.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "meshops/core/progress.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/closing/least_triangulation.h"
#include "rbpa/space/closing/mesh_around.h"
#include "rbpa/space/closing/simple_loops.h"
#include "rbpa/space/closing/triangle_sides.h"

namespace rbpa {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using space::Chord;
using space::RimTriangle;
using space::SimpleLoop;

/// Triangulations that are tried for a loop of so many corners: more where one costs less.
std::size_t attempts_for(std::size_t corners) {
  constexpr std::size_t most = 100, least = 10, steps = 100'000'000;
  const std::size_t each = std::min(corners, std::size_t{300}) * std::min(corners, std::size_t{300}) * corners / 6 + 1;
  return std::clamp(steps / each, least, most);
}

template <typename Value>
void add_sorted(std::vector<Value>& to, const std::vector<Value>& values) {
  to.insert(to.end(), values.begin(), values.end());
  std::sort(to.begin(), to.end());
  to.erase(std::unique(to.begin(), to.end()), to.end());
}

class Closing {
 public:
  Closing(std::span<const Point3> points, std::span<const Triangle> triangles,
          std::span<const std::vector<std::uint32_t>> loops, const space::BoundarySides& sides,
          const SurfaceOptions& options)
      : points_(points),
        loops_(space::simple_loops(points, loops)),
        around_(points, triangles, loops_),
        vertices_(points.size()),
        threads_(loops_.size() < 2 ? 1 : options.threads),
        go_on_([this, &options] {
          const std::lock_guard<std::mutex> lock(asking_);
          return !options.progress || options.progress({made_, points_.size()});
        }) {
    for (const SimpleLoop& loop : loops_) {
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
    // The best of each loop by itself; then in one order, as each may be in the way of the next.
    std::vector<std::optional<space::RimFilling>> first(loops_.size());
    std::vector<std::vector<Chord>> taken(loops_.size());
    for_each_index(threads_, loops_.size(), [&](std::size_t i) {
      if (rims_[i].size() < 3) return;
      meshops::Steps step(go_on_);
      taken[i] = around_.taken_chords(loops_[i]);
      first[i] = space::least_triangulation(rims_[i], taken[i], {}, step);
    });
    for (std::uint32_t i = 0; i < loops_.size(); ++i) {
      if (!go_on_()) throw meshops::Cancelled();
      close(i, std::move(first[i]), std::move(taken[i]));
    }
    assemble();
    return std::move(result_);
  }

 private:
  void close(std::uint32_t i, std::optional<space::RimFilling> filling, std::vector<Chord> taken) {
    const space::Rim& rim = rims_[i];
    HoleFill& fill = result_.loops[loops_[i].loop];
    if (rim.size() < 3) return merge(loops_[i]);  // two edges that lie on each other
    meshops::Steps step(go_on_);
    std::vector<Chord> chords = taken;
    std::vector<RimTriangle> triangles;
    bool has_crossed = false;
    for (std::size_t left = attempts_for(rim.size()); filling; --left) {
      const space::Faults faults = around_.faults(i, rim, filling->triangles);
      if (faults.none()) return accept(i, *filling);
      has_crossed = has_crossed || !faults.crossing.empty() || !faults.triangles.empty();
      add_sorted(taken, faults.taken);
      add_sorted(chords, faults.taken);
      add_sorted(chords, faults.crossing);
      add_sorted(triangles, faults.triangles);
      if (left == 0) break;
      filling = space::least_triangulation(rim, chords, triangles, step);
    }
    if (fill.outcome != HoleOutcome::filled) return;  // of a part that came first
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

  /// The new triangles, loop by loop, of vertices as they are at last.
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
  std::vector<SimpleLoop> loops_;
  std::vector<space::Rim> rims_;
  space::MeshAround around_;
  meshops::DisjointSets vertices_;
  std::vector<std::vector<RimTriangle>> filled_;
  HoleFilling result_;
  Threads threads_;
  std::mutex asking_;
  std::size_t made_ = 0;  // triangles
  meshops::GoOn go_on_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> boundary_loops(std::span<const Triangle> triangles) {
  return space::loops_of(triangles);
}

HoleFilling fill_holes(std::span<const Point3> points, std::span<const Triangle> triangles,
                       std::span<const std::vector<std::uint32_t>> loops, const SurfaceOptions& options) {
  space::check_points(points);
  for (const Triangle& t : triangles)
    for (const std::uint32_t vertex : t)
      meshops::require(vertex < points.size(), "fill_holes: expected triangles of these points");
  const space::BoundarySides sides(triangles, loops);
  return Closing(points, triangles, loops, sides, options).run();
}

}  // namespace rbpa
