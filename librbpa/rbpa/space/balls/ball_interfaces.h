// What:   computes how much of the surface of each group of balls the balls of another group cover: interfaces of
//         chains, residues, grains.
// Law:    the covered area of a group is the area of the group alone minus its part of the surface of the union of both
//         groups; it is at least 0. The covered areas of two groups sum to area(A) + area(B) − area(A ∪ B). Which
//         groups meet is decided exactly; areas are rounded like those of measure_balls(). Other groups make no
//         difference to a pair. In a cell that repeats, an image of a ball belongs to the group of the ball, and areas
//         are those per cell.
// Cost:   that of measuring each group, and each two groups of which balls are near each other.
// Source: Lee and Richards, The interpretation of protein structures: estimation of static accessibility (1971).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/no_group.h"
#include "rbpa/space/balls/measure_ball_frames.h"
#include "rbpa/space/balls/measure_balls.h"

namespace rbpa {

/// Two groups of balls that meet: balls of both share a contact, or a ball of one group hides one of the other. Areas
/// are in the squared unit of the coordinates.
struct BallInterface {
  std::array<std::uint32_t, 2> groups;  ///< ascending
  /// For each group, the area of its surface that the balls of the other group cover.
  std::array<double, 2> areas{};
  /// Area of the interface itself: of the contacts, in the union of both groups, between balls of different groups.
  double contact_area = 0;
};

struct BallInterfaces {
  /// For each ball, its area on the surface of the union of its own group; 0 for a ball in no group.
  std::vector<double> areas_alone;
  std::vector<BallInterface> all;  ///< ascending by groups
};

/// Computes the interface of each two groups that meet. `groups` has the number of each ball's group, or no_group. If
/// spheres of two groups are equal, they count for the group of the ball of lower index. The options `contacts` and
/// `derivatives` are ignored; Progress counts groups, then pairs of groups.
/// Requires: what measure_ball_frames() requires; one group for each center.
/// Throws:   what measure_ball_frames() throws, the balls of a group or of two being a frame; InvalidInput unless there
///           is one group for each center.
RBPA_API BallInterfaces ball_interfaces(const BallFrame& balls, std::span<const std::uint32_t> groups,
                                        const MeasureBallsOptions& options = {});

}  // namespace rbpa
