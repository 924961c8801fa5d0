#include "rbpa/space/balls/measure_ball_frames.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/error.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::BallFrame;
using rbpa::BallMeasures;
using rbpa::measure_ball_frames;
using rbpa::Point3;

TEST_SUITE_BEGIN("space");

namespace {

/// Frames of different sizes: some empty, some in a plane.
struct Frames {
  std::vector<std::vector<Point3>> centers;
  std::vector<std::vector<double>> radii;

  Frames(std::size_t count, std::size_t balls) {
    Random random(count);
    for (std::size_t f = 0; f < count; ++f) {
      centers.emplace_back();
      radii.emplace_back();
      for (std::size_t i = 0; i < (f * balls) % 97; ++i) {
        centers.back().push_back({random.unit(), random.unit(), f % 3 == 1 ? 0.5 : random.unit()});
        radii.back().push_back(random.between(0, 0.3));
      }
    }
  }
  std::vector<BallFrame> views() const {
    std::vector<BallFrame> all;
    for (std::size_t f = 0; f < centers.size(); ++f) all.push_back({centers[f], radii[f]});
    return all;
  }
};

}  // namespace

TEST_CASE("the measures of frames are those of each by itself, whatever the number of threads") {
  for (const std::size_t count : {0U, 1U, 2U, 30U}) {
    const Frames frames(count, 40);
    for (const unsigned threads : {1U, 2U, 0U}) {
      const auto all = measure_ball_frames(frames.views(), {.probe = 0.05, .contacts = true, .threads = threads});
      REQUIRE(all.size() == count);
      for (std::size_t f = 0; f < count; ++f) {
        const BallMeasures one =
            rbpa::measure_balls(frames.centers[f], frames.radii[f], {.probe = 0.05, .contacts = true});
        CHECK(all[f].volume == one.volume);
        CHECK(all[f].areas == one.areas);
        CHECK(all[f].volumes == one.volumes);
        CHECK(all[f].hidden == one.hidden);
        CHECK(all[f].contacts.size() == one.contacts.size());
      }
    }
  }
}

TEST_CASE("a message names the frame, counted from 0, if there are several") {
  Frames frames(3, 40);
  frames.radii[2][5] = -1;
  const auto views = frames.views();
  CHECK_THROWS_WITH_AS(measure_ball_frames(views),
                       "frame 2: radius 5: found -1 with the probe 0, expected a finite sum of at least 0",
                       rbpa::InvalidInput);
  CHECK_THROWS_WITH_AS(measure_ball_frames(std::span(views).subspan(2)),
                       "radius 5: found -1 with the probe 0, expected a finite sum of at least 0", rbpa::InvalidInput);
}

TEST_CASE("progress counts frames, and ends the run") {
  const Frames frames(30, 40);
  for (const unsigned threads : {1U, 2U}) {
    std::size_t last = 0, calls = 0;
    const auto count = [&](const rbpa::Progress& progress) {
      CHECK(progress.triangles >= last);
      CHECK(progress.points == 30);
      last = progress.triangles;
      return ++calls < 1000;
    };
    measure_ball_frames(frames.views(), {.threads = threads, .progress = count});
    CHECK(last == 30);
    calls = 985;
    last = 0;
    CHECK_THROWS_AS(measure_ball_frames(frames.views(), {.threads = threads, .progress = count}), rbpa::Cancelled);
    CHECK(last < 30);
  }
}

TEST_SUITE_END();
