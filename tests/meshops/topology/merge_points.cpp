#include "meshops/topology/merge_points.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "meshops/core/contract.h"
#include "meshops/topology/soup_defects.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using Cycle = std::vector<std::uint32_t>;

/// Returns the least of all rotations of a cycle, in either direction.
Cycle canonical(const Cycle& cycle) {
  Cycle best;
  Cycle turned = cycle;
  for (int direction = 0; direction < 2; ++direction) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      if (best.empty() || turned < best) best = turned;
    }
    std::reverse(turned.begin(), turned.end());
  }
  return best;
}

/// Checks the result by the definitions, face after face.
void check_merged(const PolygonSoup& s, const std::vector<std::uint32_t>& least) {
  CAPTURE(text(s));
  const MergedPoints found = merge_points(s, least);
  std::vector<std::uint32_t> points;
  for (std::uint32_t p = 0; p < s.points; ++p)
    if (least[p] == p) points.push_back(p);
  CHECK(found.point_was == points);
  CHECK(found.soup.points == points.size());
  CHECK(found.merged == s.points - points.size());
  std::vector<std::size_t> faces;
  std::size_t corners = 0, degenerate = 0, duplicate = 0;
  std::set<Cycle> seen;
  for (std::size_t f = 0; f < s.faces(); ++f) {
    Cycle cycle;
    for (std::size_t i = 0; i < s.face(f).size(); ++i) {
      const std::uint32_t corner = least[s.face(f)[i]];
      if (corner != least[s.face(f)[(i + 1) % s.face(f).size()]]) cycle.push_back(corner);
    }
    const std::set<std::uint32_t> distinct(cycle.begin(), cycle.end());
    if (cycle.size() < 3 || distinct.size() < cycle.size()) {
      ++degenerate;
    } else if (!seen.insert(canonical(cycle)).second) {
      ++duplicate;
    } else {
      corners += s.face(f).size() - cycle.size();
      REQUIRE(found.face_was.size() > faces.size());
      Cycle left;
      for (const std::uint32_t corner : found.soup.face(faces.size())) left.push_back(points[corner]);
      CHECK(canonical(left) == canonical(cycle));
      faces.push_back(f);
    }
  }
  CHECK(found.face_was == faces);
  CHECK(found.corners == corners);
  CHECK(found.degenerate == degenerate);
  CHECK(found.duplicate == duplicate);
  for (const SoupDefect& defect : find_defects(found.soup)) {
    CHECK(defect.kind != SoupDefectKind::degenerate_face);
    CHECK(defect.kind != SoupDefectKind::duplicate_face);
  }
}

}  // namespace

TEST_SUITE("merge_points") {
  TEST_CASE("kept and removed faces and points agree with the definitions") {
    std::mt19937 random(31);
    for (int i = 0; i < 400; ++i) {
      PolygonSoup s = i % 2 == 0 ? random_soup(random) : broken_surface(random);
      if (s.points == 0) continue;
      for (std::uint32_t& corner : s.corners)
        corner = std::min<std::uint32_t>(corner, static_cast<std::uint32_t>(s.points) - 1);
      std::vector<std::uint32_t> least(s.points);
      std::iota(least.begin(), least.end(), 0U);
      check_merged(s, least);
      for (std::uint32_t p = 1; p < s.points; ++p)
        if (random() % 3 == 0) least[p] = least[random() % p];
      check_merged(s, least);
    }
  }

  TEST_CASE("a torus whose points were separated is a torus again after merging") {
    const PolygonSoup torus = grid_soup(5, 4, true, true);
    PolygonSoup apart;
    std::vector<std::uint32_t> least;
    std::vector<std::uint32_t> first(torus.points, ~0U);
    for (std::size_t f = 0; f < torus.faces(); ++f) {
      Cycle cycle;
      for (const std::uint32_t corner : torus.face(f)) {
        const auto p = static_cast<std::uint32_t>(apart.points++);
        first[corner] = std::min(first[corner], p);
        least.push_back(first[corner]);
        cycle.push_back(p);
      }
      apart.add_face(cycle);
    }
    const MergedPoints found = merge_points(apart, least);
    CHECK(found.soup.points == torus.points);
    CHECK(report(found.soup).genus == 1);
    CHECK(found.degenerate + found.duplicate + found.corners == 0);
  }

  TEST_CASE("wrong calls are refused") {
    const PolygonSoup s = soup(4, {{0, 1, 2}, {0, 2, 3}});
    CHECK_THROWS_AS(merge_points(s, std::vector<std::uint32_t>{0, 1, 2}), ContractViolation);
    CHECK_THROWS_WITH(
        merge_points(s, std::vector<std::uint32_t>{0, 2, 2, 3}),
        "merge_points: least[1] is 2, expected the lowest index of the points that are merged with point 1");
    CHECK_THROWS_AS(merge_points(s, std::vector<std::uint32_t>{0, 0, 1, 3}), ContractViolation);
    CHECK_THROWS_WITH(merge_points(soup(2, {{0, 1, 2}}), std::vector<std::uint32_t>{0, 1}),
                      "merge_points: a corner of face 0 is not a point");
  }
}

TEST_SUITE("keep_faces") {
  TEST_CASE("kept faces stay in their order, with their points") {
    std::mt19937 random(37);
    for (int i = 0; i < 200; ++i) {
      const PolygonSoup s = broken_surface(random);
      std::vector<bool> kept(s.faces());
      for (std::size_t f = 0; f < s.faces(); ++f) kept[f] = random() % 2 == 0;
      const SoupPart part = keep_faces(s, kept);
      std::set<std::uint32_t> used;
      std::size_t next = 0;
      for (std::size_t f = 0; f < s.faces(); ++f) {
        if (!kept[f]) continue;
        REQUIRE(next < part.face_was.size());
        CHECK(part.face_was[next] == f);
        REQUIRE(part.soup.face(next).size() == s.face(f).size());
        for (std::size_t k = 0; k < s.face(f).size(); ++k) {
          CHECK(part.point_was[part.soup.face(next)[k]] == s.face(f)[k]);
          used.insert(s.face(f)[k]);
        }
        ++next;
      }
      CHECK(part.soup.faces() == next);
      CHECK(part.soup.points == used.size());
      CHECK(part.point_was == std::vector<std::uint32_t>(used.begin(), used.end()));
    }
  }

  TEST_CASE("wrong calls are refused") {
    CHECK_THROWS_AS(keep_faces(soup(3, {{0, 1, 2}}), {}), ContractViolation);
    CHECK_THROWS_WITH(keep_faces(soup(3, {{0, 1, 3}}), {true}), "keep_faces: a corner of face 0 is not a point");
    CHECK(keep_faces(soup(3, {{0, 1, 3}}), {false}).soup.points == 0);
  }
}
