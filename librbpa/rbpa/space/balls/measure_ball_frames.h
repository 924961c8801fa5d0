// What:   measures many sets of balls in one call, such as the frames of a simulation.
// How:    one thread measures a frame; several do if there are at least twice as many threads as frames.
// Law:    the measures of a frame are those of measure_balls(), or of measure_periodic_balls() if the frame has a cell,
//         whatever the other frames and the threads are.
// Cost:   that of these functions for each frame, shared among the threads.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/balls/measure_balls.h"
#include "rbpa/space/balls/periodic_balls.h"

namespace rbpa {

/// The balls of a frame. Frames may have different numbers of balls.
struct BallFrame {
  std::span<const Point3> centers;
  std::span<const double> radii;                     ///< one for each center
  std::optional<RepeatingCell> cell = std::nullopt;  ///< the cell of the frame, if it repeats
};

/// Returns the measures of the balls of each frame, in the order of the frames. `options` are those of measure_balls();
/// but if there are several frames, Progress::triangles is the number of finished frames, and Progress::points the
/// number of all frames.
/// Requires: for each frame, what measure_balls() or measure_periodic_balls() requires.
/// Throws:   what these functions throw; if there are several frames, the message of InvalidInput begins with the
///           number of the frame, from 0, as in "frame 3: ".
RBPA_API std::vector<PeriodicBallMeasures> measure_ball_frames(std::span<const BallFrame> frames,
                                                               const MeasureBallsOptions& options = {});

}  // namespace rbpa
