#include "meshops/topology/soup_defects.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "meshops/core/contract.h"
#include "support/arguments.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using Kind = SoupDefectKind;

/// Returns the texts of all defects.
std::vector<std::string> defect_lines(const PolygonSoup& soup) {
  std::vector<std::string> lines;
  for (const SoupDefect& defect : find_defects(soup)) lines.push_back(describe(defect));
  return lines;
}
using Lines = std::vector<std::string>;

/// Removes the points of components that are not orientable, because any edge at which they disagree is correct.
std::vector<SoupDefect> without_choice(std::vector<SoupDefect> defects) {
  for (SoupDefect& defect : defects)
    if (defect.kind == Kind::not_orientable) defect.points.clear();
  return defects;
}

}  // namespace

TEST_SUITE("soup_defects") {
  TEST_CASE("surfaces have no defects: with boundary, closed, of polygons, in components, with isolated points") {
    CHECK(defect_lines(PolygonSoup{}).empty());
    CHECK(defect_lines(soup(3, {})).empty());
    CHECK(defect_lines(soup(3, {{0, 1, 2}})).empty());
    CHECK(defect_lines(soup(7, {{0, 1, 2, 3}, {0, 3, 5}})).empty());
    CHECK(defect_lines(grid_soup(4, 3, false, false)).empty());
    CHECK(defect_lines(grid_soup(4, 3, true, true)).empty());
    CHECK(defect_lines(beside(grid_soup(4, 3, true, false), grid_soup(3, 3, true, true))).empty());
    // Two squares that share all corners but one, and a point at which only two faces meet.
    CHECK(defect_lines(soup(5, {{0, 1, 2, 3}, {3, 2, 1, 4}})).empty());
  }

  TEST_CASE("a corner out of range is named with its face") {
    CHECK(find_defects(soup(3, {{0, 1, 2}, {1, 0, 3}})) ==
          std::vector<SoupDefect>{{Kind::corner_out_of_range, {1, 0, 3}, {1}}});
    CHECK(defect_lines(soup(3, {{0, 1, 2}, {1, 0, 3}})) == Lines{"corner out of range: points 1 0 3, face 1"});
    CHECK(defect_lines(soup(0, {{0}})) == Lines{"corner out of range: point 0, face 0"});
    // It is the only defect reported for a face.
    CHECK(defect_lines(soup(3, {{0, 0, 4294967295U}})) == Lines{"corner out of range: points 0 0 4294967295, face 0"});
  }

  TEST_CASE("a degenerate face is named: too short, or one point twice") {
    CHECK(find_defects(soup(4, {{0, 1, 1}})) == std::vector<SoupDefect>{{Kind::degenerate_face, {0, 1, 1}, {0}}});
    CHECK(defect_lines(soup(4, {{}, {2}, {0, 1}, {0, 1, 0}, {0, 1, 2, 1}, {0, 1, 2}})) ==
          Lines{"degenerate face: face 0", "degenerate face: point 2, face 1", "degenerate face: points 0 1, face 2",
                "degenerate face: points 0 1 0, face 3", "degenerate face: points 0 1 2 1, face 4"});
  }

  TEST_CASE("a duplicate is named with the first face of the same cycle, whatever its start and direction") {
    CHECK(find_defects(soup(3, {{0, 1, 2}, {2, 1, 0}})) ==
          std::vector<SoupDefect>{{Kind::duplicate_face, {2, 1, 0}, {0, 1}}});
    CHECK(defect_lines(soup(4, {{3, 0, 1, 2}, {1, 2, 3, 0}, {0, 3, 2, 1}})) ==
          Lines{"duplicate face: points 1 2 3 0, faces 0 1", "duplicate face: points 0 3 2 1, faces 0 2"});
    // Equal points in another cycle are another face.
    for (const SoupDefect& defect : find_defects(soup(4, {{0, 1, 2, 3}, {0, 2, 1, 3}})))
      CHECK(defect.kind != Kind::duplicate_face);
  }

  TEST_CASE("an edge of three faces is named with all of them") {
    CHECK(find_defects(soup(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})) ==
          std::vector<SoupDefect>{{Kind::non_manifold_edge, {0, 1}, {0, 1, 2}}});
    CHECK(defect_lines(soup(6, {{5, 0, 3}, {2, 1, 4}, {4, 3, 0}, {3, 4, 1}, {2, 4, 3}})) ==
          Lines{"non-manifold edge: points 3 4, faces 2 3 4"});
  }

  TEST_CASE("two faces in the same direction are named with their edge") {
    CHECK(find_defects(soup(4, {{0, 1, 2}, {0, 1, 3}})) ==
          std::vector<SoupDefect>{{Kind::inconsistent_orientation, {0, 1}, {0, 1}}});
    CHECK(defect_lines(soup(5, {{4, 3, 1}, {2, 4, 3}})) == Lines{"inconsistent orientation: points 3 4, faces 0 1"});
  }

  TEST_CASE("a component that is not orientable is named by its first face, once") {
    const auto band = find_defects(moebius_band());
    std::vector<SoupDefect> flat;
    std::copy_if(band.begin(), band.end(), std::back_inserter(flat),
                 [](const SoupDefect& d) { return d.kind == Kind::not_orientable; });
    REQUIRE(flat.size() == 1);
    CHECK(flat[0].faces == std::vector<std::size_t>{0});
    CHECK(flat[0].points.size() == 2);
    CHECK(describe(flat[0]).starts_with("not orientable: points "));
    CHECK(describe(flat[0]).ends_with(", face 0"));
    for (const PolygonSoup& closed : {klein_bottle(), projective_plane()}) {
      const auto two = find_defects(beside(beside(grid_soup(2, 2, false, false), closed), moebius_band()));
      std::vector<std::size_t> firsts;
      for (const SoupDefect& d : two)
        if (d.kind == Kind::not_orientable) firsts.push_back(d.faces[0]);
      CHECK(firsts == std::vector<std::size_t>{8, 8 + closed.faces()});
    }
  }

  TEST_CASE("a pinch is named with the first face of each fan") {
    CHECK(find_defects(soup(5, {{0, 1, 2}, {0, 3, 4}})) == std::vector<SoupDefect>{{Kind::pinch, {0}, {0, 1}}});
    CHECK(defect_lines(soup(8, {{0, 1, 2}, {3, 4, 0}, {0, 2, 7}, {5, 6, 0}})) == Lines{"pinch: point 0, faces 0 1 3"});
    // Two closed surfaces that touch in two points.
    CHECK(defect_lines(
              soup(6, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 1}, {0, 5, 4}, {4, 5, 1}, {5, 0, 1}})) ==
          Lines{"non-manifold edge: points 0 1, faces 0 1 4 7"});
    CHECK(defect_lines(
              soup(7, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {5, 0, 6}})) ==
          Lines{"pinch: point 0, faces 0 4"});
    // Three faces at one edge are connected through it.
    for (const SoupDefect& defect : find_defects(soup(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})))
      CHECK(defect.kind != Kind::pinch);
  }

  TEST_CASE("faulty faces are ignored in the search for other defects") {
    CHECK(defect_lines(soup(3, {{0, 1, 2}, {0, 1, 2}, {0, 2, 1}, {0, 1, 0}, {0, 1, 9}})) ==
          Lines{"corner out of range: points 0 1 9, face 4", "degenerate face: points 0 1 0, face 3",
                "duplicate face: points 0 1 2, faces 0 1", "duplicate face: points 0 2 1, faces 0 2"});
  }

  TEST_CASE("every kind has a name of its own") {
    std::vector<std::string_view> names;
    for (int kind = 0; kind <= static_cast<int>(Kind::pinch); ++kind) names.push_back(name(static_cast<Kind>(kind)));
    CHECK(names == std::vector<std::string_view>{"corner out of range", "degenerate face", "duplicate face",
                                                 "non-manifold edge", "inconsistent orientation", "not orientable",
                                                 "pinch"});
  }

  TEST_CASE("defects of random soups are those of the definitions, in their order") {
    std::mt19937 random(1);
    std::array<int, 7> seen{};
    for (int round = 0; round < rbpa_test::trials(6000); ++round) {
      const PolygonSoup s = round % 3 ? random_soup(random) : broken_surface(random);
      const auto defects = find_defects(s);
      INFO(text(s));
      REQUIRE(without_choice(defects) == defects_by_brute_force(s));
      for (const SoupDefect& defect : defects) ++seen[static_cast<std::size_t>(defect.kind)];
    }
    for (const int times : seen) CHECK(times > 100);
  }

  TEST_CASE("the edge reported for a component that is not orientable is one of its edges of two faces") {
    std::mt19937 random(2);
    for (int round = 0; round < rbpa_test::trials(500); ++round) {
      const PolygonSoup s = broken_surface(random);
      for (const SoupDefect& defect : find_defects(s)) {
        if (defect.kind != Kind::not_orientable) continue;
        int sides = 0;
        for (std::size_t f = 0; f < s.faces(); ++f) {
          const auto face = s.face(f);
          for (std::size_t i = 0; i < face.size(); ++i) {
            const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
            if (std::min(a, b) == defect.points[0] && std::max(a, b) == defect.points[1]) ++sides;
          }
        }
        CHECK(sides >= 2);
      }
    }
  }

  TEST_CASE("shuffled soups have the shuffled defects") {
    std::mt19937 random(3);
    const auto sorted = [](std::vector<SoupDefect> defects) {
      // The first fan or face of a component, and the edge of disagreement, may differ.
      for (SoupDefect& d : defects) {
        if (d.kind == Kind::not_orientable) d.points.clear();
        if (d.kind == Kind::not_orientable || d.kind == Kind::pinch) d.faces.assign(d.faces.size(), 0);
        std::sort(d.points.begin(), d.points.end());
        std::sort(d.faces.begin(), d.faces.end());
      }
      std::sort(defects.begin(), defects.end(), [](const SoupDefect& a, const SoupDefect& b) {
        return std::tie(a.kind, a.points, a.faces) < std::tie(b.kind, b.points, b.faces);
      });
      return defects;
    };
    for (int round = 0; round < rbpa_test::trials(2000); ++round) {
      const PolygonSoup s = round % 2 ? random_soup(random) : broken_surface(random);
      auto expected = find_defects(s);
      // The first of several duplicates counts, so that their order matters.
      const Shuffled other = shuffled(s, random, std::none_of(expected.begin(), expected.end(), [](const auto& d) {
                                        return d.kind == Kind::duplicate_face;
                                      }));
      for (SoupDefect& d : expected) {
        for (std::uint32_t& p : d.points)
          if (p < s.points) p = other.point_to[p];
        for (std::size_t& f : d.faces) f = other.face_to[f];
      }
      INFO(text(s));
      REQUIRE(sorted(find_defects(other.soup)) == sorted(expected));
    }
  }

  TEST_CASE("a soup too large for handles is refused") {
    PolygonSoup s;
    s.points = std::size_t{1} << 30U;
    CHECK_THROWS_AS(find_defects(s), ContractViolation);
  }
}
