#include "rbpa/space/repair/closing/chords.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "meshops/core/progress.h"
#include "support/order.h"

using namespace rbpa::space;
using rbpa::Point3;

TEST_SUITE_BEGIN("space");

namespace {

/// Returns a rim of `size` corners: even on a circle, where many distances are equal; jumping at random; with a spacing
/// that grows from corner to corner; or between a dense cluster and a wide circle.
Rim rim_of(const std::string& kind, std::uint32_t size) {
  std::mt19937 random(size);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Point3> corners;
  for (std::uint32_t i = 0; i < size; ++i) {
    const double turn = 2 * std::acos(-1.0) * i / size;
    if (kind == "circle") corners.push_back({std::cos(turn), std::sin(turn), 0});
    if (kind == "random") corners.push_back({place(random), place(random), place(random)});
    if (kind == "growing") corners.push_back({std::ldexp(1, -static_cast<int>(i) / 4), place(random) / (1 + i), 1});
    if (kind != "cluster") continue;
    const double radius = i % 2 == 0 ? 1 : 1e-9;
    corners.push_back({radius * std::cos(turn), radius * std::sin(turn), 0});
  }
  return {corners, corners};
}

/// Returns the candidates of a rim of more than 256 corners by comparing all pairs.
std::vector<Chord> by_all_pairs(const Rim& rim) {
  std::vector<Chord> chords;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < rim.size(); ++i) corners.push_back(i);
  while (corners.size() > 64) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      std::vector<std::pair<double, std::uint32_t>> others;
      for (const std::uint32_t other : corners) {
        const Vector d = rim.places[other] - rim.places[corners[i]];
        if (other != corners[i]) others.emplace_back(dot(d, d), other);
      }
      std::sort(others.begin(), others.end());
      for (std::size_t k = 0; k < 24; ++k) chords.push_back(std::minmax(corners[i], others[k].second));
      for (std::size_t ahead = 1; ahead <= 8; ++ahead)
        chords.push_back(std::minmax(corners[i], corners[(i + ahead) % corners.size()]));
    }
    std::vector<std::uint32_t> second;
    for (std::size_t i = 0; i < corners.size(); i += 2) second.push_back(corners[i]);
    corners = second;
  }
  for (const std::uint32_t i : corners)
    for (const std::uint32_t j : corners)
      if (i < j) chords.emplace_back(i, j);
  rbpa_test::sort_distinct(chords);
  return chords;
}

}  // namespace

TEST_CASE("the candidate chords of a long rim are those of a comparison of all pairs of corners") {
  for (const std::string kind : {"circle", "random", "growing", "cluster"})
    for (const std::uint32_t size : {257U, 300U, 1000U}) {
      CAPTURE(kind);
      CAPTURE(size);
      const Rim rim = rim_of(kind, size);
      const meshops::GoOn none;
      meshops::Steps step(none);
      CHECK(candidate_chords(rim, step) == by_all_pairs(rim));
    }
}

TEST_CASE("chords of a circle of 20000 corners are found in near-linear time, and can be cancelled") {
  const Rim rim = rim_of("circle", 20000);
  std::size_t calls = 0;
  const meshops::GoOn count = [&] { return ++calls > 0; };
  meshops::Steps step(count);
  candidate_chords(rim, step);
  CHECK(calls > 100);
  CHECK(calls < 4000);  // 16384 steps each; all pairs would be 20000² / 16384 = 24414
  const meshops::GoOn stop = [] { return false; };
  meshops::Steps stopped(stop);
  CHECK_THROWS_AS(candidate_chords(rim, stopped), meshops::Cancelled);
}

TEST_SUITE_END();
