// What:   measures many sets of balls at once, such as the frames of a simulation.
// How:    a frame is measured by one thread; by several where there are fewer frames than threads.
// Law:    the measures of a frame are those of measure_balls(), whatever the other frames and the threads are.
// Cost:   that of measure_balls() for each frame, shared among the threads.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/balls/measure_balls.h"

namespace rbpa {

/// The balls of a frame; frames may have different numbers of them.
struct BallFrame {
  std::span<const Point3> centers;
  std::span<const double> radii;  ///< one for each center
};

/// Measures the balls of each frame. `options` are as for measure_balls(); of several frames Progress::triangles is the
/// number of those that are done, and Progress::points that of all.
/// Requires: of each frame what measure_balls() requires.
/// Throws:   as measure_balls(); the message of InvalidInput begins with "frame 3: ", counted from 0, if there are
///           several.
RBPA_API std::vector<BallMeasures> measure_ball_frames(std::span<const BallFrame> frames,
                                                       const MeasureBallsOptions& options = {});

}  // namespace rbpa
