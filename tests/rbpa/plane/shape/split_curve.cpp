#include "rbpa/plane/shape/split_curve.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

TEST_SUITE_BEGIN("shape");

namespace {

using Indices = std::vector<std::uint32_t>;

/// Returns the rings, each from its least index, sorted: the same wherever the curve begins.
std::vector<Indices> rings_of(Indices curve) {
  std::vector<Indices> expected;
  rbpa::CurveSplitter splitter(100);
  for (std::size_t turn = 0; turn < curve.size(); ++turn) {
    std::vector<rbpa::Ring> rings;
    splitter.split(curve, rings);
    std::vector<Indices> all;
    for (rbpa::Ring& ring : rings) {
      std::rotate(ring.points.begin(), std::min_element(ring.points.begin(), ring.points.end()), ring.points.end());
      all.push_back(ring.points);
    }
    std::sort(all.begin(), all.end());
    if (turn == 0) expected = all;
    CHECK(all == expected);
    std::rotate(curve.begin(), curve.begin() + 1, curve.end());
  }
  return expected;
}

}  // namespace

TEST_CASE("a curve without repetition is one ring") {
  CHECK(rings_of({0, 1, 2}) == std::vector<Indices>{{0, 1, 2}});
  CHECK(rings_of({5, 3, 9, 1}) == std::vector<Indices>{{1, 5, 3, 9}});
}

TEST_CASE("a point that is passed k times joins k rings") {
  CHECK(rings_of({0, 1, 2, 0, 3, 4}) == std::vector<Indices>{{0, 1, 2}, {0, 3, 4}});
  CHECK(rings_of({0, 1, 2, 0, 3, 4, 0, 5, 6}) == std::vector<Indices>{{0, 1, 2}, {0, 3, 4}, {0, 5, 6}});
}

TEST_CASE("rings in a row, and rings on rings, are separated") {
  CHECK(rings_of({0, 1, 2, 3, 4, 2, 5}) == std::vector<Indices>{{0, 1, 2, 5}, {2, 3, 4}});
  CHECK(rings_of({0, 1, 2, 3, 4, 5, 6, 4, 7, 2, 8}) == std::vector<Indices>{{0, 1, 2, 8}, {2, 3, 4, 7}, {4, 5, 6}});
}

TEST_SUITE_END();
