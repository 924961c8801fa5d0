// What: computes the shapes of many sets of points (groups) in one call, each group on its own: a footprint for every
//       building, a hull for every cluster.
// Law:  the result of a group equals the result of a call with the points of the group alone, but has indices of the
//       input. The result does not depend on threads. A group with points or a radius that a single call refuses does
//       not end the run: shapes_of_groups() says in the result why that group has no polygon.
// Cost: that of the single calls, shared among threads, without the fixed cost of a call:
//       docs/reference/performance.md.
// Note: independent of OpenMesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/alpha_choice.h"
#include "rbpa/base/api.h"
#include "rbpa/base/no_group.h"
#include "rbpa/base/point.h"
#include "rbpa/base/triangle.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// The points of each group: group g has members[offsets[g]] to members[offsets[g + 1] − 1].
struct Groups {
  std::vector<std::uint64_t> offsets = {0};  ///< size() + 1 numbers, the first 0, none less than the one before
  std::vector<std::uint32_t> members = {};   ///< input indices, strictly ascending within each group

  std::size_t size() const { return offsets.size() - 1; }  ///< number of groups
  /// Returns the members of a group. Requires: `group` is below size(); not checked.
  std::span<const std::uint32_t> operator[](std::size_t group) const {
    return std::span(members).subspan(offsets[group], offsets[group + 1] - offsets[group]);
  }
};

/// Returns the groups 0 to count − 1: point i is in group labels[i]. A group may be empty.
/// Throws: InvalidInput when a label is neither below `count` nor no_group, or there are more than 357,913,941 labels.
/// Cost:   linear in the labels and groups.
RBPA_API Groups groups_of(std::span<const std::uint32_t> labels, std::size_t count);

struct GroupOptions {
  MaxThreads threads = 0;  ///< maximum number; 0: all processors
  /// Callback that is called with the number of finished groups, one call at a time but from any thread of the run.
  /// Returning false ends the run with Cancelled. The callback is called after each chunk: at most 1,024 groups with at
  /// most 4,096 points together, or one larger group. shapes_of_groups() also calls it within groups of at least 16,384
  /// points.
  std::function<bool(std::size_t)> go_on = {};
};

/// A group, as the visitor of for_each_group() receives it.
struct Group {
  std::size_t number = 0;
  std::span<const Point> points = {};           ///< contiguous in memory
  std::span<const std::uint32_t> members = {};  ///< for each entry of `points`, its input index
};

/// Calls visit(group) once for each group, in any order; several threads may call it at the same time. The group is
/// valid until visit() returns.
/// Throws: InvalidInput when offsets or members are not as Groups requires, a member is not the index of a point, or
///         there are more than 357,913,941 points, before any visit; any exception of `visit`; Cancelled. After
///         Cancelled or an exception of `visit`, some groups are not visited.
/// Cost:   linear in the members, and the calls of visit().
RBPA_API void for_each_group(std::span<const Point> points, const Groups& groups,
                             const std::function<void(const Group&)>& visit, const GroupOptions& options = {});

/// The choice of the radius of each group.
struct GroupAlpha {
  /// Radii: one for all groups, or one for each group, NaN for a group that has none; empty: `choice` has the radius or
  /// the rule.
  std::span<const double> given = {};
  /// The radius of all groups, or the rule that chooses a radius for each group; by default the least radius at which
  /// all points of the group are in one solid component. If a group has fewer plateaus than the rank, its last plateau
  /// is taken.
  AlphaChoice choice = {.rule = AlphaRule::automatic};
};

struct GroupShapesOptions : GroupOptions {
  PolygonFilter filter = {};  ///< applied to each group on its own
  bool triangles = false;     ///< whether GroupShapes::triangles is filled in
};

/// The reason why a group has no polygon.
struct GroupProblem {
  std::size_t group = 0;
  std::string what;  ///< for example "no points", "all points are collinear" or "no part has an area >= 5"
  friend bool operator==(const GroupProblem&, const GroupProblem&) = default;
};

/// The solid alpha complexes of groups. Entry g of a vector belongs to group g, unless stated otherwise.
struct GroupShapes {
  /// The given or chosen radius of each group. NaN if a point of the group is not finite, if the radius that is given
  /// for this group is not above 0, or if the rule finds no radius.
  std::vector<double> alphas;
  /// The polygons of all groups, one group after another, each sorted as by outline_polygons(); input indices. Group g
  /// has the polygons polygon_begin[g] to polygon_begin[g + 1] − 1.
  std::vector<Polygon> polygons;
  std::vector<std::uint64_t> polygon_begin = {0};
  std::vector<PolygonTotals> totals;  ///< totals of the polygons of each group
  /// The triangles of group g are numbers triangle_begin[g] to triangle_begin[g + 1] − 1, counted even if `triangles`
  /// is not filled in.
  std::vector<std::uint64_t> triangle_begin = {0};
  /// Only on request: the triangles of all groups, one group after another, each sorted as by alpha_complex(); input
  /// indices.
  std::vector<Triangle> triangles;
  std::vector<GroupProblem> problems;  ///< for groups without a polygon, ascending
  std::size_t duplicates = 0;          ///< number of points that equal an earlier point of their group
};

/// Computes the solid alpha complex of each group. Groups may overlap. Each group that has no polygon is listed in
/// `problems`, also if one of its points is not finite, or the radius given for it is not above 0.
/// Requires: 0 < alpha ≤ infinity or alpha is NaN, if there is one radius for all groups; 0 < cover ≤ 1,
///           1 ≤ max_components and 1 ≤ rank, if the rule uses them; bounds of the filter of at least 0.
/// Throws:   InvalidInput as for_each_group(), when the number of radii is not 0, 1 or the number of groups, or when
///           the one radius, max_components or rank is out of its bounds, before anything is computed;
///           ContractViolation when cover is out of its bounds, and InvalidInput when a bound of the filter is, as
///           soon as a group needs the number; Cancelled.
RBPA_API GroupShapes shapes_of_groups(std::span<const Point> points, const Groups& groups, const GroupAlpha& alpha,
                                      const GroupShapesOptions& options = {});

}  // namespace rbpa
