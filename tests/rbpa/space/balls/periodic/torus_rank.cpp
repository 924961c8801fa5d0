#include "rbpa/space/balls/periodic/torus_rank.h"

#include <doctest/doctest.h>

#include <vector>

TEST_SUITE_BEGIN("space");

namespace {

unsigned rank_of(const std::vector<rbpa::space::Boxes>& vectors) {
  rbpa::space::Rank rank;
  for (const auto& v : vectors) rank.add(v);
  return rank.value();
}

}  // namespace

TEST_CASE("the rank of integer vectors is the number of independent directions") {
  CHECK(rank_of({}) == 0);
  CHECK(rank_of({{0, 0, 0}}) == 0);
  CHECK(rank_of({{0, 0, 0}, {0, -2, 0}, {0, 5, 0}}) == 1);
  CHECK(rank_of({{1, 2, 3}, {-2, -4, -6}, {3, 6, 9}}) == 1);
  CHECK(rank_of({{1, 2, 3}, {1, 2, 4}}) == 2);
  CHECK(rank_of({{1, 0, 0}, {0, 1, 0}, {7, -3, 0}}) == 2);
  CHECK(rank_of({{1, 0, 0}, {0, 1, 0}, {7, -3, 1}}) == 3);
  CHECK(rank_of({{1, 1, 0}, {0, 1, 1}, {1, 0, 1}}) == 3);
  CHECK(rank_of({{1, 1, 0}, {0, 1, 1}, {1, 0, -1}}) == 2);
  constexpr std::int32_t large = 2'000'000'000;
  CHECK(rank_of({{large, large, large}, {large, large, -large}, {large, large, large - 1}}) == 2);
  CHECK(rank_of({{large, large, large}, {large, large, -large}, {large, large - 1, large}}) == 3);
}
