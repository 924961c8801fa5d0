#include "rbpa/space/surface/holes.h"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

#include "meshops/core/contract.h"
#include "rbpa/base/arrays/boundary_walk.h"
#include "rbpa/base/arrays/distinct.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/agreement.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/surface/levels/interior.h"
#include "rbpa/space/surface/levels/neighborhood_subset.h"
#include "rbpa/space/surface/levels/sub_surface.h"
#include "rbpa/space/surface/star/exposed_at.h"

namespace rbpa {
namespace {

/// Returns the boundary curves, without causes and lengths.
std::vector<Hole> curves_of(const Surface& surface, Steps& step) {
  std::vector<Hole> curves;
  BoundaryWalk walk(space::arrays_of(surface));
  const auto place = [](const RimEdge& e) { return std::tie(e.from, e.to, e.triangle); };
  const auto is_before = [&](const RimEdge& e, const RimEdge& f) { return place(e) < place(f); };
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    step();
    for (std::size_t across = 0; across < 3; ++across) {
      if (!walk.is_new({t, across})) continue;
      auto& edges = curves.emplace_back().edges;
      walk.walk_from({t, across}, [&](const BoundarySide& side) {
        step();
        const Triangle& corners = surface.triangles[side.triangle];
        RimEdge& edge = edges.emplace_back();
        edge.from = corners[(side.across + 2) % 3];
        edge.to = corners[(side.across + 1) % 3];
        edge.triangle = side.triangle;
      });
      std::rotate(edges.begin(), std::min_element(edges.begin(), edges.end(), is_before), edges.end());
    }
  }
  std::sort(curves.begin(), curves.end(),
            [&](const Hole& h, const Hole& i) { return is_before(h.edges.front(), i.edges.front()); });
  return curves;
}

/// Returns the length of a curve. Adds edges by ascending length, so that the bits do not depend on where the curve
/// begins.
double length_of(const Hole& curve, std::span<const Point3> points) {
  std::vector<double> lengths;
  for (const RimEdge& e : curve.edges) {
    const Point3 &p = points[e.from], &q = points[e.to];
    lengths.push_back(space::distance(p, q));
  }
  std::sort(lengths.begin(), lengths.end());
  double sum = 0;
  for (const double length : lengths) sum += length;
  return sum;
}

/// The exposed triangles of one radius at the points at which rim edges begin.
class Exposed {
 public:
  Exposed(std::span<const Point3> points, std::span<const Duplicate> duplicates,
          const std::vector<std::uint8_t>& at_rim, double radius, const SurfaceOptions& options) {
    const space::NeighborhoodSubset near = space::neighborhood_subset(points, {}, duplicates, at_rim, radius);
    std::vector<std::uint8_t> wanted;
    for (const std::uint32_t i : near.input) wanted.push_back(at_rim[i]);
    exposed_ = space::exposed_at(near.points, radius, wanted, options);
    for (space::ExposedAt& of : exposed_)  // indices ascend alike, so the order does not change
      of = {near.input[of.at], near.input[of.second], near.input[of.third], near.input[of.beyond]};
  }

  /// Returns the triangle to which the ball rolls from `triangle` over its side at `edge`; nothing if the ball does not
  /// rest on `triangle`.
  std::optional<Triangle> next(const Triangle& triangle, const RimEdge& edge) const {
    const auto k = static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), edge.from) - triangle.begin());
    const space::ExposedAt wanted{triangle[k % 3], triangle[(k + 1) % 3], triangle[(k + 2) % 3], 0};
    const auto found = std::lower_bound(exposed_.begin(), exposed_.end(), wanted);
    if (found == exposed_.end() || found->at != wanted.at || found->second != wanted.second ||
        found->third != wanted.third)
      return std::nullopt;
    Triangle next = {found->at, found->third, found->beyond};
    std::rotate(next.begin(), std::min_element(next.begin(), next.end()), next.end());
    return next;
  }

 private:
  std::vector<space::ExposedAt> exposed_;
};

/// Fills in the cause of an edge, and its `corners` and `sides`. Requires: edge.next is set; `smaller` is the interior
/// of the surface of the smaller radii, if there are any.
void explain(RimEdge& edge, const space::Agreement& agreement, const std::optional<space::Interior>& smaller) {
  edge.corners = agreement.disagreeing(edge.next);
  const auto disagreeing = std::count(edge.corners.begin(), edge.corners.end(), true);
  if (disagreeing == 3) {
    edge.cause = RimCause::nothing_within_reach;  // also where `next` is the same triangle from behind
  } else if (disagreeing > 0) {
    edge.cause = RimCause::normals_disagree;
  } else {
    edge.cause = RimCause::blocked;
    bool is_blocked = false;
    for (std::size_t k = 0; k < 3 && smaller; ++k) {
      const std::uint32_t u = edge.next[(k + 1) % 3], v = edge.next[(k + 2) % 3];
      edge.corners[k] = smaller->has_point(edge.next[k]);
      edge.sides[k] = !smaller->has_point(u) && !smaller->has_point(v) && smaller->has_edge(u, v);
      is_blocked = is_blocked || edge.corners[k] || edge.sides[k];
    }
    if (!is_blocked)
      throw meshops::ContractViolation("holes: triangle " + std::to_string(edge.triangle) +
                                       " has a boundary side where the surface of these points continues");
  }
}

}  // namespace

std::vector<Hole> surface_curves(std::span<const Point3> points, const Surface& surface, const GoOn& go_on) {
  require_linked(space::arrays_of(surface), points.size(), go_on);
  Steps step(go_on);
  std::vector<Hole> curves = curves_of(surface, step);
  for (Hole& curve : curves) {
    step(curve.edges.size());
    curve.length = length_of(curve, points);
  }
  return curves;
}

std::vector<Hole> holes(std::span<const Point3> points, std::span<const Point3> normals, std::span<const double> radii,
                        const Surface& surface, const SurfaceOptions& options) {
  space::check_radii(radii);
  space::check_points(points);
  space::check_normals(points, normals);
  require_duplicates("holes", surface.duplicates, points.size());
  const auto level_of = [&](std::uint32_t t) { return surface.levels.empty() ? 0 : surface.levels[t]; };
  if (!surface.levels.empty() || radii.size() != 1)
    meshops::require_one_each("holes", surface.levels.size(), "levels", surface.triangles.size(), "triangles");
  const GoOn go_on = go_on_of(options.progress, points.size(), surface.triangles.size());
  std::vector<Hole> curves = surface_curves(points, surface, go_on);
  Steps step(go_on);
  std::vector<RimEdge*> open;
  for (Hole& curve : curves)
    for (RimEdge& edge : curve.edges) open.push_back(&edge);
  const space::Agreement agreement(points, normals, surface.duplicates);
  for (std::size_t i = radii.size(); i > 0 && !open.empty(); --i) {
    const auto level = static_cast<std::uint32_t>(i - 1);
    std::vector<std::uint8_t> at_rim(points.size(), 0);
    for (const RimEdge* edge : open)
      if (level_of(edge->triangle) <= level) at_rim[edge->from] = 1;
    const Exposed exposed(points, surface.duplicates, at_rim, radii[level], options);
    std::optional<space::Interior> smaller;
    if (level > 0) {
      const Surface part = space::sub_surface(level, surface);
      smaller.emplace(space::arrays_of(part), points.size());
    }
    std::erase_if(open, [&](RimEdge* edge) {
      step(4);
      if (level_of(edge->triangle) > level) return false;
      const Triangle& triangle = surface.triangles[edge->triangle];
      const auto next = exposed.next(triangle, *edge);
      if (!next) return false;
      edge->level = level;
      edge->next = *next;
      explain(*edge, agreement, smaller);
      return true;
    });
  }
  if (!open.empty())
    throw meshops::ContractViolation("holes: no ball of its radius rests on triangle " +
                                     std::to_string(open.front()->triangle));
  return curves;
}

std::vector<Hole> holes(std::span<const Point3> points, std::span<const Point3> normals, double radius,
                        const Surface& surface, const SurfaceOptions& options) {
  return holes(points, normals, std::span(&radius, 1), surface, options);
}

}  // namespace rbpa
