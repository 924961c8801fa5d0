// What:   many sets of points in one call, each by itself: a footprint for every building, a hull for every cluster.
// Law:    a group has what a call with its points alone returns, with the indices of the input. Nothing depends on the number of
//         threads, or on the other groups: what is wrong with one is a sentence in the result, and the rest goes on.
// Cost:   that of the calls, shared among threads, without what a call costs beside its points: docs/performance.md.
// Note:   independent of OpenMesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/triangle.h"
#include "rbpa/covering.h"
#include "rbpa/shape.h"

namespace rbpa {

/// Which points are in which group: group g has members[offsets[g]] to members[offsets[g + 1] − 1].
struct Groups {
  std::vector<std::uint64_t> offsets = {0};  ///< ascending, one more than there are groups; the first is 0
  std::vector<std::uint32_t> members = {};   ///< input indices, ascending within each group

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t group) const {
    return std::span(members).subspan(offsets[group], offsets[group + 1] - offsets[group]);
  }
};

/// As a label: the point is in no group.
inline constexpr std::uint32_t no_group = 0xffffffff;

/// Groups 0 to count − 1 of the points with these labels. A group may be empty.
/// Throws: InvalidInput when a label is neither below `count` nor no_group. Cost: linear.
RBPA_API Groups groups_of(std::span<const std::uint32_t> labels, std::size_t count);

struct GroupOptions {
  /// Threads that work at most, the calling one included. 0 = all processors; larger values are capped.
  unsigned threads = 0;
  /// Called as go_on(groups that are done) every few milliseconds, one call at a time but from any thread of the run; returning
  /// false cancels it. Empty: never called.
  std::function<bool(std::size_t)> go_on = {};
};

/// A group as it is visited.
struct Group {
  std::size_t number = 0;
  std::span<const Point> points = {};           ///< side by side
  std::span<const std::uint32_t> members = {};  ///< of each of these points, its input index
};

/// Calls visit(Group) once for each group, in any order and thread.
/// Throws: InvalidInput when the offsets or members are no Groups of these points; what `visit` throws, after which some groups
///         are not visited; Cancelled.
RBPA_API void for_each_group(std::span<const Point> points, const Groups& groups,
                             const std::function<void(const Group&)>& visit, const GroupOptions& options = {});

/// How the radius of each group is found.
struct GroupAlpha {
  /// One radius for all groups, or one for each; none: they are chosen.
  std::span<const double> given = {};
  /// The least radius that satisfies this (covering.h); by default all points of a group in one component.
  Covering covering = {.share = 1, .max_components = 1};
  /// Above 0: that of the plateau of this rank (plateaus.h), or of the last there is.
  std::size_t plateau = 0;
};

struct GroupShapesOptions : GroupOptions {
  PolygonFilter filter = {};
  bool triangles = false;  ///< fills in GroupShapes::triangles
};

/// Why a group has no polygon.
struct GroupProblem {
  std::size_t group = 0;
  std::string what;  ///< "all points are collinear"
  friend bool operator==(const GroupProblem&, const GroupProblem&) = default;
};

/// Solid alpha complexes of groups. Entry g of a vector is that of group g, unless said otherwise.
struct GroupShapes {
  std::vector<double> alphas;     ///< the radius that was given or chosen; NaN where the points have no triangle at any
  std::vector<Polygon> polygons;  ///< of all groups, in their order, each as polygons() sorts its own; input indices
  std::vector<std::uint64_t> polygon_begin = {
      0};  ///< the polygons of group g are numbers polygon_begin[g] to [g + 1] − 1
  std::vector<PolygonTotals> totals;
  std::vector<std::uint64_t> triangle_begin = {0};  ///< the same of triangles, also where these are not kept
  std::vector<Triangle> triangles;     ///< if they are asked for: of all groups, each as triangulate() has its own
  std::vector<GroupProblem> problems;  ///< of groups without a polygon, ascending
};

/// Requires: 0 < alpha ≤ infinity, where one is given for all. Groups need not have anything in common, nor points that are
///           finite: each that has no polygon is in `problems`.
/// Throws:   InvalidInput as for_each_group(), and when the number of radii is neither that of groups, nor one, nor none;
///           Cancelled.
RBPA_API GroupShapes shapes_of_groups(std::span<const Point> points, const Groups& groups, const GroupAlpha& alpha,
                                      const GroupShapesOptions& options = {});

}  // namespace rbpa
