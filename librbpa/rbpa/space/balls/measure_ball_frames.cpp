#include "rbpa/space/balls/measure_ball_frames.h"

#include <algorithm>
#include <mutex>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/base/parallel/threads.h"

namespace rbpa {
namespace {

PeriodicBallMeasures measured(const BallFrame& frame, const MeasureBallsOptions& options) {
  if (frame.cell) return measure_periodic_balls(frame.centers, frame.radii, *frame.cell, options);
  return {measure_balls(frame.centers, frame.radii, options), {}};
}

}  // namespace

std::vector<PeriodicBallMeasures> measure_ball_frames(std::span<const BallFrame> frames,
                                                      const MeasureBallsOptions& options) {
  if (frames.size() == 1) return {measured(frames[0], options)};
  std::vector<PeriodicBallMeasures> result(frames.size());
  Threads threads(options.threads);
  MeasureBallsOptions of_one = options;
  of_one.threads =
      static_cast<MaxThreads>(std::max<std::size_t>(threads.count() / std::max<std::size_t>(frames.size(), 1), 1));
  std::mutex one_call;
  std::size_t done = 0;
  if (options.progress)
    of_one.progress = [&](const Progress&) {
      const std::lock_guard<std::mutex> lock(one_call);
      return options.progress({done, frames.size()});
    };
  for_each_index(threads, frames.size(), [&](std::size_t i) {
    try {
      result[i] = measured(frames[i], of_one);
    } catch (const InvalidInput& e) {
      throw InvalidInput("frame " + std::to_string(i) + ": " + e.what());
    }
    const std::lock_guard<std::mutex> lock(one_call);
    ++done;
    stop_if_cancelled(options.progress, {done, frames.size()});
  });
  return result;
}

}  // namespace rbpa
