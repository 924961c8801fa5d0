// What: computes the shapes of many sets of points in one call, each on its own: a footprint for every building, a hull
//       for every cluster.
// Law:  the result of a group equals the result of a call with the group's points alone, but has indices of the input.
//       The result does not depend on the number of threads, or on the other groups: shapes_of_groups() reports an
//       error in one group as a sentence in the result, and computes the other groups.
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
#include "rbpa/base/point.h"
#include "rbpa/base/triangle.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// The points of each group: group g has members[offsets[g]] to members[offsets[g + 1] − 1].
struct Groups {
  std::vector<std::uint64_t> offsets = {0};  ///< ascending, one more than there are groups; the first is 0
  std::vector<std::uint32_t> members = {};   ///< input indices, ascending within each group

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t group) const {
    return std::span(members).subspan(offsets[group], offsets[group + 1] - offsets[group]);
  }
};

/// The label of a point that is in no group.
inline constexpr std::uint32_t no_group = 0xffffffff;

/// Returns the groups 0 to count − 1 of the points with these labels. A group may be empty.
/// Throws: InvalidInput when a label is neither below `count` nor no_group, or there are too many labels
///         (alpha_complex.h).
/// Cost:   linear.
RBPA_API Groups groups_of(std::span<const std::uint32_t> labels, std::size_t count);

struct GroupOptions {
  MaxThreads threads = 0;  ///< maximum number; 0: all processors
  /// Callback that is called with the number of finished groups, one call at a time but from any thread of the run.
  /// Returning false ends the run with Cancelled. for_each_group() calls it only between chunks of groups: at most
  /// 1,024 groups with at most 4,096 points together, or one larger group.
  std::function<bool(std::size_t)> go_on = {};
};

/// A group, as the visitor of for_each_group() receives it.
struct Group {
  std::size_t number = 0;
  std::span<const Point> points = {};           ///< contiguous in memory
  std::span<const std::uint32_t> members = {};  ///< for each of these points, its input index
};

/// Calls visit(group) once for each group, in any order; several threads may call it at the same time. The group is
/// valid until visit() returns.
/// Throws: InvalidInput when the offsets or members are not valid Groups of these points, or there are too many points
///         (alpha_complex.h); any exception of `visit`; Cancelled. After Cancelled or an exception of `visit`, some
///         groups are not visited.
/// Cost:   linear in the members, and the calls of visit().
RBPA_API void for_each_group(std::span<const Point> points, const Groups& groups,
                             const std::function<void(const Group&)>& visit, const GroupOptions& options = {});

/// The choice of the radius of each group.
struct GroupAlpha {
  /// One radius for all groups, or one for each; empty: `choice` has the radius or the rule.
  std::span<const double> given = {};
  /// The radius of all groups, or the rule that chooses a radius for each group; its rank must be at least 1. By
  /// default the least radius at which all points of the group are in one solid component. A rank above the number of a
  /// group's plateaus means its last plateau.
  AlphaChoice choice = {.rule = AlphaRule::automatic};
};

struct GroupShapesOptions : GroupOptions {
  PolygonFilter filter = {};
  bool triangles = false;  ///< whether GroupShapes::triangles are filled in
};

/// The reason why a group has no polygon.
struct GroupProblem {
  std::size_t group = 0;
  std::string what;  ///< for example "all points are collinear"
  friend bool operator==(const GroupProblem&, const GroupProblem&) = default;
};

/// The solid alpha complexes of groups. Entry g of a vector belongs to group g, unless stated otherwise.
struct GroupShapes {
  /// The given or chosen radius of each group. NaN if a point is not finite, if the group's own radius is not above 0,
  /// or if the rule finds no radius.
  std::vector<double> alphas;
  /// The polygons of all groups, one group after another, each sorted as by outline_polygons(); input indices. Group g
  /// has the polygons polygon_begin[g] to polygon_begin[g + 1] − 1.
  std::vector<Polygon> polygons;
  std::vector<std::uint64_t> polygon_begin = {0};
  std::vector<PolygonTotals> totals;
  /// The triangles of group g are numbers triangle_begin[g] to triangle_begin[g + 1] − 1, counted even if not kept.
  std::vector<std::uint64_t> triangle_begin = {0};
  /// Only on request: the triangles of all groups, one group after another, each sorted as by alpha_complex(); input
  /// indices.
  std::vector<Triangle> triangles;
  std::vector<GroupProblem> problems;  ///< for groups without a polygon, ascending
};

/// Computes the solid alpha complex of each group. Groups may overlap. Each group that has no polygon is listed in
/// `problems`, also if a point is not finite or the group's own radius is not above 0.
/// Requires: 0 < alpha ≤ infinity, if one radius is given for all groups; 0 < cover ≤ 1, 1 ≤ max_components and
///           1 ≤ rank, if the rule uses them.
/// Throws:   InvalidInput as for_each_group(), when the number of radii is not 0, 1 or the number of groups, when the
///           one radius is not above 0, when max_components or rank is 0, and when a bound of the filter is negative or
///           not a number; ContractViolation when cover is out of its bounds; Cancelled.
RBPA_API GroupShapes shapes_of_groups(std::span<const Point> points, const Groups& groups, const GroupAlpha& alpha,
                                      const GroupShapesOptions& options = {});

}  // namespace rbpa
