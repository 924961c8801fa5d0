// The neighbors of rows of four numbers, compared with every pair of rows.
#include "rbpa/space/solid/triples/link_faces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "support/random.h"

using namespace rbpa_test;

TEST_SUITE_BEGIN("space");

namespace {

using Row = std::array<std::uint32_t, 4>;

std::set<std::uint32_t> face(const Row& row, std::size_t across) {
  std::set<std::uint32_t> corners(row.begin(), row.end());
  corners.erase(row[across]);
  return corners;
}

}  // namespace

TEST_CASE("rows are neighbors across each common face, and across no other") {
  Random random(3111);
  rbpa::Threads threads(2);
  std::size_t linked = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t bound = 5 + random.below(trial % 10 == 0 ? 40'000 : 20);
    // Random rows, without rows that have a face of two others.
    std::vector<Row> rows;
    std::vector<std::set<std::uint32_t>> faces;
    for (int tries = 0; tries < 60; ++tries) {
      std::set<std::uint32_t> corners;
      while (corners.size() < 4) corners.insert(static_cast<std::uint32_t>(random.below(bound)));
      Row row;
      std::copy(corners.begin(), corners.end(), row.begin());
      if (random.chance(0.5)) std::swap(row[2], row[3]);
      std::vector<std::set<std::uint32_t>> own;
      for (std::size_t k = 0; k < 4; ++k) own.push_back(face(row, k));
      if (std::any_of(own.begin(), own.end(),
                      [&](const auto& f) { return std::count(faces.begin(), faces.end(), f) > 1; }))
        continue;
      faces.insert(faces.end(), own.begin(), own.end());
      rows.push_back(row);
    }
    std::sort(rows.begin(), rows.end());
    const auto neighbors = rbpa::space::link_faces(rows, bound, threads);
    REQUIRE(neighbors.size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        std::uint32_t expected = 0xffffffff;
        for (std::size_t j = 0; j < rows.size(); ++j)
          for (std::size_t l = 0; l < 4; ++l)
            if (j != i && face(rows[i], k) == face(rows[j], l)) expected = static_cast<std::uint32_t>(j);
        REQUIRE(neighbors[i][k] == expected);
        linked += expected != 0xffffffff;
      }
  }
  CHECK(linked > 500);
}

TEST_SUITE_END();
