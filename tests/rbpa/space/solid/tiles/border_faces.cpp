// Faces of tetrahedra, and pairs of equal faces, compared with all pairs.
#include "rbpa/space/solid/tiles/border_faces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "support/random.h"

using rbpa::Row;
using rbpa::space::border_face;
using rbpa::space::BorderFace;
using namespace rbpa_test;

TEST_SUITE_BEGIN("space");

namespace {

constexpr std::uint32_t none = 0xffffffff;

}  // namespace

TEST_CASE("a face has ascending corners, and neighbors see it from opposite sides") {
  // (0, 1, 2, 3) is positively oriented; across from 3 is a point on the other side of (0, 1, 2).
  const Row t = {10, 20, 30, 40}, turned = {20, 10, 30, 50};
  CHECK(border_face(t, 7, 3).corners == std::array<std::uint32_t, 3>{10, 20, 30});
  CHECK(border_face(t, 7, 3).face == 31);
  CHECK(border_face(turned, 2, 3).corners == std::array<std::uint32_t, 3>{10, 20, 30});
  CHECK(rbpa::space::is_ascending_outside(t, 3) != rbpa::space::is_ascending_outside(turned, 3));
  // Even permutations of the corners are the same tetrahedron.
  const Row even = {20, 30, 10, 40};
  CHECK(rbpa::space::is_ascending_outside(t, 3) == rbpa::space::is_ascending_outside(even, 3));
  CHECK(rbpa::space::is_ascending_outside(t, 0) == rbpa::space::is_ascending_outside(even, 2));
  // Counter-clockwise seen from outside: the face of (0, 1, 2, 3) across from 0 is (1, 2, 3).
  CHECK(rbpa::space::is_ascending_outside(t, 0));
  CHECK(!rbpa::space::is_ascending_outside(t, 1));
}

TEST_CASE("faces that occur twice become neighbors, and others do not change") {
  Random random(3191);
  std::size_t linked = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const std::size_t bound = 5 + random.below(trial % 10 == 0 ? 10'000 : 12);
    std::vector<Row> rows;
    std::vector<std::set<std::uint32_t>> faces;
    for (int tries = 0; tries < 60; ++tries) {
      std::set<std::uint32_t> corners;
      while (corners.size() < 4) corners.insert(static_cast<std::uint32_t>(random.below(bound)));
      Row row;
      std::copy(corners.begin(), corners.end(), row.begin());
      std::swap(row[0], row[random.below(4)]);
      bool fits = true;
      for (std::size_t k = 0; k < 4; ++k) {
        std::set<std::uint32_t> face = corners;
        face.erase(row[k]);
        fits = fits && std::count(faces.begin(), faces.end(), face) < 2;
      }
      if (!fits) continue;
      for (std::size_t k = 0; k < 4; ++k) {
        std::set<std::uint32_t> face = corners;
        face.erase(row[k]);
        faces.push_back(face);
      }
      rows.push_back(row);
    }
    std::vector<BorderFace> border;
    for (std::uint32_t t = 0; t < rows.size(); ++t)
      for (std::size_t k = 0; k < 4; ++k) border.push_back(border_face(rows[t], t, k));
    random.shuffle(border);
    meshops::FreshVector<Row> neighbors(rows.size());
    for (Row& row : neighbors) row = {none, none, none, none};
    rbpa::space::link_border_faces(border, bound, neighbors);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      std::uint32_t other = none;
      for (std::size_t j = 0; j < faces.size(); ++j)
        if (j != i && faces[j] == faces[i]) other = static_cast<std::uint32_t>(j / 4);
      CHECK(neighbors[i / 4][i % 4] == other);
      linked += other != none ? 1u : 0u;
    }
  }
  CHECK(linked > 1000);
}

TEST_SUITE_END();
