#include "meshops/topology/repair.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "meshops/topology/build_mesh.h"
#include "meshops/topology/merge_points.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "support/arguments.h"
#include "support/check_sound.h"
#include "support/meshes.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using Kind = RepairKind;
using Lines = std::vector<std::string>;
using Corners = std::vector<std::uint32_t>;
using Ends = std::pair<std::uint32_t, std::uint32_t>;

Lines repair_lines(const Repair& repaired) {
  Lines lines;
  for (const RepairStep& step : repaired.steps) lines.push_back(describe(step));
  return lines;
}
Lines repair_lines(const PolygonSoup& s) { return repair_lines(repair(s)); }

Corners corners_of(const PolygonSoup& s, std::size_t f) {
  const auto face = s.face(f);
  return {face.begin(), face.end()};
}

/// Returns the corners, from the least on.
Corners cycle(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Returns for the ends of each edge the faces there, by their numbers in the given soup.
std::map<Ends, std::vector<std::size_t>> edges_of(const Repair& r, bool given_ends) {
  std::map<Ends, std::vector<std::size_t>> edges;
  for (std::size_t f = 0; f < r.soup.faces(); ++f) {
    const Corners face = corners_of(r.soup, f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
      if (given_ends) a = r.stands_on[a], b = r.stands_on[b];
      edges[{std::min(a, b), std::max(a, b)}].push_back(r.face_was[f]);
    }
  }
  return edges;
}

/// Checks that the steps list every difference between the given soup and the repaired one, and nothing else.
void check_accounted(const PolygonSoup& s, const Repair& r) {
  std::map<Kind, std::vector<RepairStep>> of;
  for (const RepairStep& step : r.steps) of[step.kind].push_back(step);

  REQUIRE(r.stands_on.size() == r.soup.points);
  std::map<std::uint32_t, int> copies;
  for (std::size_t p = 0; p < r.soup.points; ++p) {
    if (p < s.points) CHECK(r.stands_on[p] == p);
    CHECK(r.stands_on[p] < s.points);
    ++copies[r.stands_on[p]];
  }
  std::vector<RepairStep> splits;
  for (const auto& [point, count] : copies)
    if (count > 1) splits.push_back({Kind::point_split, {point}, {}});
  CHECK(of[Kind::point_split] == splits);

  REQUIRE(r.face_was.size() == r.soup.faces());
  CHECK(std::is_sorted(r.face_was.begin(), r.face_was.end()));
  const std::set<std::size_t> kept(r.face_was.begin(), r.face_was.end());
  std::vector<RepairStep> dropped;
  for (std::size_t f = 0; f < s.faces(); ++f)
    if (!kept.contains(f)) dropped.push_back({Kind::face_dropped, corners_of(s, f), {f}});
  CHECK(of[Kind::face_dropped] == dropped);

  std::vector<RepairStep> corners_dropped, reversed;
  for (std::size_t f = 0; f < r.soup.faces(); ++f) {
    const Corners given = corners_of(s, r.face_was[f]);
    Corners clean;
    for (std::size_t i = 0; i < given.size(); ++i)
      if (given[i] == given[(i + 1) % given.size()])
        corners_dropped.push_back({Kind::corner_dropped, {given[i]}, {r.face_was[f]}});
      else
        clean.push_back(given[i]);
    Corners now = corners_of(r.soup, f);
    for (std::uint32_t& corner : now) corner = r.stands_on[corner];
    Corners other_way = clean;
    std::reverse(other_way.begin(), other_way.end());
    if (cycle(now) == cycle(clean)) continue;
    REQUIRE(cycle(now) == cycle(other_way));
    RepairStep step{Kind::face_reversed, clean, {r.face_was[f]}};
    if (cycle(of[Kind::face_reversed][reversed.size()].points) == cycle(clean))
      step.points = of[Kind::face_reversed][reversed.size()].points;
    reversed.push_back(step);
  }
  CHECK(of[Kind::corner_dropped] == corners_dropped);
  CHECK(of[Kind::face_reversed] == reversed);

  const auto now = edges_of(r, false);
  std::vector<RepairStep> cuts;
  for (const auto& [ends, faces] : edges_of(r, true)) {
    bool together = false;
    for (const auto& [copy, faces_now] : now) {
      const std::uint32_t a = r.stands_on[copy.first], b = r.stands_on[copy.second];
      together = together || (faces_now == faces && ends == Ends(std::min(a, b), std::max(a, b)));
    }
    if (!together) cuts.push_back({Kind::edge_cut, {ends.first, ends.second}, faces});
  }
  CHECK(of[Kind::edge_cut] == cuts);
}

bool same(const PolygonSoup& a, const PolygonSoup& b) {
  return a.points == b.points && a.corners == b.corners && a.begin == b.begin;
}

}  // namespace

TEST_SUITE("repair") {
  TEST_CASE("a corner named twice in a row is dropped") {
    const Repair r = repair(soup(4, {{0, 1, 1, 2}, {3, 2, 1, 3}}));
    CHECK(r.steps == std::vector<RepairStep>{{Kind::corner_dropped, {1}, {0}}, {Kind::corner_dropped, {3}, {1}}});
    CHECK(repair_lines(r) == Lines{"corner dropped: point 1, face 0", "corner dropped: point 3, face 1"});
    CHECK(same(r.soup, soup(4, {{0, 1, 2}, {3, 2, 1}})));
    CHECK(repair_lines(soup(3, {{0, 0, 0, 1, 2, 2}})) == Lines{"corner dropped: point 0, face 0",
                                                               "corner dropped: point 0, face 0",
                                                               "corner dropped: point 2, face 0"});
  }

  TEST_CASE("invalid faces are dropped, and no other step names them") {
    const Repair r =
        repair(soup(4, {{}, {0, 1}, {0, 0, 1, 1}, {0, 1, 2}, {0, 1, 2, 1}, {2, 1, 0}, {1, 2, 9}, {0, 1, 1, 2}}));
    CHECK(repair_lines(r) == Lines{"face dropped: face 0", "face dropped: points 0 1, face 1",
                                   "face dropped: points 0 0 1 1, face 2", "face dropped: points 0 1 2 1, face 4",
                                   "face dropped: points 2 1 0, face 5", "face dropped: points 1 2 9, face 6",
                                   "face dropped: points 0 1 1 2, face 7"});
    CHECK(same(r.soup, soup(4, {{0, 1, 2}})));
    CHECK(r.face_was == std::vector<std::size_t>{3});
    CHECK(r.stands_on == Corners{0, 1, 2, 3});
  }

  TEST_CASE("the smaller part of the faces of a piece is reversed, and in a tie the first face stays") {
    CHECK(repair_lines(soup(4, {{0, 1, 2}, {0, 1, 3}})) == Lines{"face reversed: points 0 1 3, face 1"});
    const Repair r = repair(soup(5, {{0, 1, 2}, {0, 1, 3}, {0, 3, 4}}));
    CHECK(repair_lines(r) == Lines{"face reversed: points 0 1 2, face 0"});
    CHECK(same(r.soup, soup(5, {{0, 2, 1}, {0, 1, 3}, {0, 3, 4}})));
    // Each piece is treated by itself.
    CHECK(repair_lines(beside(soup(4, {{0, 1, 2}, {0, 1, 3}}), soup(5, {{0, 1, 2}, {0, 1, 3}, {0, 3, 4}}))) ==
          Lines{"face reversed: points 0 1 3, face 1", "face reversed: points 4 5 6, face 2"});
  }

  TEST_CASE("three faces at one edge are separated") {
    const Repair r = repair(soup(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
    CHECK(repair_lines(r) ==
          Lines{"edge cut: points 0 1, faces 0 1 2", "point split: point 0", "point split: point 1"});
    CHECK(same(r.soup, soup(9, {{0, 1, 2}, {5, 6, 3}, {7, 8, 4}})));
    CHECK(r.stands_on == Corners{0, 1, 2, 3, 4, 1, 0, 0, 1});
  }

  TEST_CASE("fans at one point are separated") {
    const Repair r = repair(soup(5, {{0, 1, 2}, {3, 4, 0}}));
    CHECK(repair_lines(r) == Lines{"point split: point 0"});
    CHECK(same(r.soup, soup(6, {{0, 1, 2}, {3, 4, 5}})));
  }

  TEST_CASE("tetrahedra on one edge stay whole") {
    const Repair r =
        repair(soup(6, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}}));
    CHECK(repair_lines(r) ==
          Lines{"edge cut: points 0 1, faces 0 1 4 5", "point split: point 0", "point split: point 1"});
    const TopologyReport whole = report(r.soup);
    CHECK(whole.components == 2);
    CHECK(whole.boundary_curves == 0);
    CHECK(whole.betti == BettiNumbers{2, 0, 2});
  }

  TEST_CASE("closed solids that share walls stay closed") {
    // Cells of a grid of columns × rows × layers cubes, cut in triangles or not, whose faces point outward.
    const auto cells = [](std::uint32_t columns, std::uint32_t rows, std::uint32_t layers, bool cut) {
      const auto at = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        return (i * (rows + 1) + j) * (layers + 1) + k;
      };
      PolygonSoup all;
      all.points = at(columns, rows, layers) + 1;
      for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j)
          for (std::uint32_t k = 0; k < layers; ++k) {
            const auto p = [&](unsigned bits) { return at(i + (bits & 1U), j + (bits >> 1U & 1U), k + (bits >> 2U)); };
            for (const auto& side : {std::array{0U, 4U, 6U, 2U},
                                     {1U, 3U, 7U, 5U},
                                     {0U, 1U, 5U, 4U},
                                     {2U, 6U, 7U, 3U},
                                     {0U, 2U, 3U, 1U},
                                     {4U, 5U, 7U, 6U}}) {
              std::array<std::uint32_t, 4> face{};
              for (std::size_t c = 0; c < 4; ++c) face[c] = p(side[c]);
              std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
              if (!cut) all.add_face(face);
              if (cut) all.add_face(std::array{face[0], face[1], face[2]});
              if (cut) all.add_face(std::array{face[0], face[2], face[3]});
            }
          }
      return all;
    };
    PolygonSoup tetrahedra =
        soup(5, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 1, 2}, {0, 4, 1}, {1, 4, 2}, {2, 4, 0}});
    PolygonSoup against = tetrahedra;  // the second one points inward: no wall, as the faces repeat each other
    std::reverse(against.corners.begin() + 12, against.corners.end());
    struct Row {
      const char* name;
      PolygonSoup given;
      std::size_t solids, dropped;
    };
    std::mt19937 random(9);
    for (const Row& row : {
             Row{"two tetrahedra", tetrahedra, 2, 0},
             {"two tetrahedra that face each other's way", against, 0, 1},
             {"two cubes", cells(2, 1, 1, false), 2, 0},
             {"three cubes in a row", cells(3, 1, 1, false), 3, 0},
             {"three cubes in a row, of triangles", cells(1, 1, 3, true), 3, 0},
             {"four cubes around an edge: which faces belong together there does not follow", cells(2, 2, 1, false), 0,
              4},
             {"a sheet with two sides", soup(4, {{0, 1, 2}, {2, 1, 0}, {0, 2, 3}, {3, 2, 0}}), 0, 2},
         })
      for (int shuffle = 0; shuffle < 4; ++shuffle) {
        INFO(std::string(row.name) << " " << shuffle);
        const PolygonSoup given = shuffle == 0 ? row.given : shuffled(row.given, random, true).soup;
        const Repair r = repair(given);
        CHECK(find_defects(r.soup).empty());
        check_accounted(given, r);
        CHECK(given.faces() - r.soup.faces() == row.dropped);
        const TopologyReport now = report(r.soup);
        std::size_t closed = 0;
        for (const ComponentReport& piece : now.per_component) closed += piece.boundary_curves == 0;
        CHECK(closed == row.solids);
        // Points that are merged come with walls as well, which a repair then separates.
        std::vector<std::uint32_t> least(given.points);
        std::iota(least.begin(), least.end(), 0U);
        const MergedPoints merged = merge_points(given, least);
        CHECK(merged.duplicate == row.dropped);
        CHECK(merged.soup.faces() == r.soup.faces());
      }
  }

  TEST_CASE("a surface that is not orientable is cut open and stays one piece") {
    for (const PolygonSoup& s :
         {moebius_band(), projective_plane(), klein_bottle(), grid_soup(5, 4, true, false, true)}) {
      const Repair r = repair(s);
      const TopologyReport cut = report(r.soup);
      INFO(text(s));
      CHECK(cut.faces == s.faces());
      CHECK(cut.solid_components == 1);
      CHECK(cut.per_component[0].orientable);
      CHECK(cut.boundary_curves > 0);
      CHECK(std::any_of(r.steps.begin(), r.steps.end(), [](const auto& step) { return step.kind == Kind::edge_cut; }));
      check_accounted(s, r);
    }
    // A Möbius band is cut across.
    CHECK(report(repair(moebius_band()).soup).euler() == 1);
  }

  TEST_CASE("every kind has a name of its own") {
    std::vector<std::string_view> names;
    for (int kind = 0; kind <= static_cast<int>(Kind::point_split); ++kind)
      names.push_back(name(static_cast<Kind>(kind)));
    CHECK(names ==
          std::vector<std::string_view>{"corner dropped", "face dropped", "face reversed", "edge cut", "point split"});
  }

  TEST_CASE("repair() makes an oriented manifold of any soup, and reports every change") {
    std::mt19937 random(8);
    std::map<Kind, int> seen;
    for (int round = 0; round < rbpa_test::trials(12000); ++round) {
      const PolygonSoup s = round % 2 ? random_soup(random) : broken_surface(random);
      INFO(text(s));
      const Repair r = repair(s);
      REQUIRE(find_defects(r.soup).empty());
      TestMesh mesh;
      build_mesh(mesh, r.soup);
      check_sound(mesh);
      check_accounted(s, r);
      for (const RepairStep& step : r.steps) ++seen[step.kind];
      const Repair again = repair(r.soup);
      CHECK(again.steps.empty());
      CHECK(same(again.soup, r.soup));
      if (!find_defects(s).empty()) continue;
      CHECK(r.steps.empty());
      CHECK(same(r.soup, s));
    }
    for (int kind = 0; kind <= static_cast<int>(Kind::point_split); ++kind)
      CHECK(seen[static_cast<Kind>(kind)] > rbpa_test::trials(500));
  }

  TEST_CASE("if only directions or fans are wrong, the pieces stay as they are, with at most half of each reversed") {
    std::mt19937 random(9);
    int pinched = 0, reversed = 0;
    for (int round = 0; round < rbpa_test::trials(4000); ++round) {
      const PolygonSoup s = broken_surface(random);
      const auto defects = find_defects(s);
      if (std::any_of(defects.begin(), defects.end(), [](const SoupDefect& d) {
            return d.kind != SoupDefectKind::pinch && d.kind != SoupDefectKind::inconsistent_orientation;
          }))
        continue;
      const Repair r = repair(s);
      const TopologyReport before = report(s), after = report(r.soup);
      INFO(text(s));
      CHECK(before.per_component == after.per_component);
      CHECK(after.components == before.solid_components + before.isolated);
      std::size_t turned = 0;
      for (const RepairStep& step : r.steps) {
        CHECK(step.kind != Kind::edge_cut);
        turned += step.kind == Kind::face_reversed;
      }
      CHECK(2 * turned <= s.faces());
      pinched += before.pinches > 0;
      reversed += turned > 0;
    }
    CHECK(pinched > 50);
    CHECK(reversed > 100);
  }

  TEST_CASE("an edge is cut only where three faces meet or a piece is not orientable") {
    std::mt19937 random(10);
    int needed = 0;
    for (int round = 0; round < rbpa_test::trials(4000); ++round) {
      const PolygonSoup s = round % 2 ? random_soup(random) : broken_surface(random);
      const Repair r = repair(s);
      PolygonSoup cleaned;  // the kept faces, unchanged
      cleaned.points = s.points;
      for (std::size_t f = 0; f < r.soup.faces(); ++f) {
        Corners face = corners_of(r.soup, f);
        for (std::uint32_t& corner : face) corner = r.stands_on[corner];
        cleaned.add_face(face);
      }
      // Faces run as after the repair: an edge that does not fit now is one at which it had to be cut.
      std::set<Corners> bad;
      for (const SoupDefect& d : find_defects(cleaned))
        if (d.kind == SoupDefectKind::non_manifold_edge || d.kind == SoupDefectKind::inconsistent_orientation)
          bad.insert(d.points);
      std::set<Corners> cut;
      for (const RepairStep& step : r.steps)
        if (step.kind == Kind::edge_cut) cut.insert(step.points);
      INFO(text(s));
      CHECK(cut == bad);
      needed += !cut.empty();
    }
    CHECK(needed > rbpa_test::trials(500));
  }
}
