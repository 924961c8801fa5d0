#include "rbpa/base/run/input.h"

#include <doctest/doctest.h>

#include <limits>
#include <string>

#include "rbpa/base/error.h"
#include "support/refusal_of.h"

TEST_SUITE_BEGIN("run");

namespace {

std::string refusal(std::size_t points) {
  return rbpa_test::refusal_of<rbpa::InvalidInput>([&] { rbpa::check_number(points); });
}

}  // namespace

TEST_CASE("a number of points is accepted if and only if its halfedges can be numbered") {
  const auto max_halfedges = [](std::size_t points) { return 2 * (3 * points - 6); };  // a triangle as outer boundary
  constexpr std::size_t numbers = std::numeric_limits<int>::max();
  CHECK(max_halfedges(rbpa::max_points) <= numbers);
  CHECK(max_halfedges(rbpa::max_points + 3) > numbers);
  for (const std::size_t few : {std::size_t{0}, std::size_t{3}}) CHECK(refusal(few).empty());
  CHECK(refusal(rbpa::max_points).empty());
  CHECK(refusal(rbpa::max_points + 1) ==
        "357913942 points, expected at most 357913941, whose halfedges can be numbered in int");
  CHECK_FALSE(refusal(std::numeric_limits<std::size_t>::max()).empty());
}

TEST_SUITE_END();
