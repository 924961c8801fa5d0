// What:   computes how much of the surface of each group of balls the balls of another group cover: interfaces of
//         chains, residues, grains.
// Law:    the area of a group's surface that another group covers is the group's area alone less its part of the
//         surface of both: 0 or above, and what is covered of both is area(A) + area(B) − area(A ∪ B). Which groups
//         meet is exact; areas are rounded, as those of measure_balls(). Other groups make no difference to a pair.
// Cost:   measure_balls() of each group, and of each pair of groups whose bounding boxes meet; shared among threads.
// Source: Lee and Richards, The interpretation of protein structures: estimation of static accessibility (1971).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/no_group.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/balls/measure_balls.h"

namespace rbpa {

/// Two groups of balls that meet: balls of both share a contact, or a ball of one is hidden by the other.
struct BallInterface {
  std::array<std::uint32_t, 2> groups;  ///< ascending
  /// For each group: the area of the surface of its balls that those of the other group cover.
  std::array<double, 2> areas{};
  /// The area of the contacts between balls of the two groups, in the union of both: of the interface itself.
  double contact_area = 0;
};

struct BallInterfaces {
  /// For each ball: its area on the surface of the union of its own group; 0 if it is in no group.
  std::vector<double> areas_alone;
  std::vector<BallInterface> all;  ///< ascending by groups
};

/// Computes the interfaces. `groups` has a number for each ball, or no_group; equal spheres of two groups count for the
/// one of the ball of lower index. Of `options`, contacts and derivatives are ignored; Progress counts groups, then
/// pairs.
/// Requires: as measure_balls(); one group for each center.
/// Throws:   as measure_balls().
RBPA_API BallInterfaces ball_interfaces(std::span<const Point3> centers, std::span<const double> radii,
                                        std::span<const std::uint32_t> groups, const MeasureBallsOptions& options = {});

}  // namespace rbpa
