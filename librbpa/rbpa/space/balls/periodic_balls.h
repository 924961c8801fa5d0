// What:   computes volume and surface area of a union of balls in a cell that repeats, as in a crystal or a simulation
//         under periodic boundary conditions, the part of each ball, and the contacts.
// How:    measure_balls() measures the balls with all images that may meet them; the measures of images are left out.
//         docs/explanation/space.md, section 27.
// Law:    centers are moved into the cell by multiples of its edges, and so are images: both are rounded. For the
//         rounded centers the law of measure_balls() holds.
// Cost:   that of measure_balls() for the balls and the images that are as near to the cell as two radii.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/balls/measure_balls.h"

namespace rbpa {

/// A cell that repeats along its edges.
struct RepeatingCell {
  std::array<Point3, 3> edges{};                     ///< three vectors in any directions, with a volume
  std::array<bool, 3> repeats = {true, true, true};  ///< whether the cell repeats along each of them
  RBPA_API double volume() const;                    ///< rounded
};

struct PeriodicBallMeasures : BallMeasures {
  /// For each contact, the numbers of edges by which the second ball is moved from its input position, so that it
  /// touches the first one at its input position. Empty unless contacts are requested.
  std::vector<std::array<std::int32_t, 3>> contact_offsets;
};

/// Measures the balls of one cell: volume and area are those of the union of the balls and all images, per cell.
/// Centers may be outside of the cell. A contact is listed once, at its ball of lower index; the two balls of a contact
/// may be images of one. Balls that are equal modulo the cell share their part of the union, as rounding decides.
/// Requires: what measure_balls() requires; a cell of finite edges, not nearly in one plane; centers fewer than 2^30
///           cells away; no radius with the probe above 50 times the distance of opposite faces.
/// Throws:   InvalidInput that names the violated requirement; what measure_balls() throws; Cancelled.
RBPA_API PeriodicBallMeasures measure_periodic_balls(std::span<const Point3> centers, std::span<const double> radii,
                                                     const RepeatingCell& cell,
                                                     const MeasureBallsOptions& options = {});

}  // namespace rbpa
