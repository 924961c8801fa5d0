#include "rbpa/space/balls/measure_ball_frames.h"

#include <algorithm>
#include <mutex>
#include <string>

#include "rbpa/base/error.h"
#include "rbpa/base/parallel/threads.h"

namespace rbpa {

std::vector<BallMeasures> measure_ball_frames(std::span<const BallFrame> frames, const MeasureBallsOptions& options) {
  if (frames.size() == 1) return {measure_balls(frames[0].centers, frames[0].radii, options)};
  std::vector<BallMeasures> result(frames.size());
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
      result[i] = measure_balls(frames[i].centers, frames[i].radii, of_one);
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
