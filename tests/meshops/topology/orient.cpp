#include "meshops/topology/orient.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "meshops/core/contract.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "support/soups.h"

using namespace meshops;
using namespace meshops::test;

namespace {

struct Run {
  std::size_t face;
  bool ascending;
};

/// Returns for the ends of each edge the faces without fault there, and their directions along it.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Run>> runs_of(const PolygonSoup& s,
                                                                            const Orientation& found) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Run>> runs;
  for (std::size_t f = 0; f < s.faces(); ++f) {
    if (found.piece[f] == Orientation::none) continue;
    const auto face = s.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
      runs[std::minmax(a, b)].push_back({f, a < b});
    }
  }
  return runs;
}

/// Tries every choice of directions of a small piece. Returns: the least number of reversed faces among choices in
/// which all agree; nothing if there is no such choice.
std::optional<std::size_t> fewest_reversed(const PolygonSoup& s, const Orientation& found, std::uint32_t piece) {
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < s.faces(); ++f)
    if (found.piece[f] == piece) faces.push_back(f);
  std::optional<std::size_t> best;
  const auto runs = runs_of(s, found);
  for (std::size_t choice = 0; choice < std::size_t{1} << faces.size(); ++choice) {
    std::set<std::size_t> reversed;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if ((choice >> i & 1) != 0) reversed.insert(faces[i]);
    const bool agrees = std::all_of(runs.begin(), runs.end(), [&](const auto& edge) {
      const std::vector<Run>& at = edge.second;
      if (at.size() != 2 || found.piece[at[0].face] != piece) return true;
      return (at[0].ascending != reversed.contains(at[0].face)) != (at[1].ascending != reversed.contains(at[1].face));
    });
    if (agrees && (!best || reversed.size() < *best)) best = reversed.size();
  }
  return best;
}

void check_orientation(const PolygonSoup& s) {
  CAPTURE(text(s));
  const Orientation found = orient(s);
  const TopologyReport r = report(s);
  REQUIRE(found.pieces.size() == r.per_component.size());
  const auto runs = runs_of(s, found);
  for (std::uint32_t p = 0; p < found.pieces.size(); ++p) {
    const SurfacePiece& piece = found.pieces[p];
    CHECK(piece.first_face == r.per_component[p].first_face);
    CHECK(piece.faces == r.per_component[p].faces);
    CHECK(piece.orientable == r.per_component[p].orientable);
    CHECK(piece.closed == std::all_of(runs.begin(), runs.end(), [&](const auto& edge) {
            const auto& at = edge.second;
            return at.size() == 2 ||
                   std::none_of(at.begin(), at.end(), [&](const Run& run) { return found.piece[run.face] == p; });
          }));
    std::size_t reversed = 0;
    for (std::size_t f = 0; f < s.faces(); ++f) reversed += found.piece[f] == p && found.reversed[f];
    if (piece.faces <= 8) {
      const std::optional<std::size_t> fewest = fewest_reversed(s, found, p);
      CHECK(fewest.has_value() == piece.orientable);
      CHECK(reversed == fewest.value_or(0));
    }
    if (2 * reversed == piece.faces) CHECK_FALSE(found.reversed[piece.first_face]);
  }
  PolygonSoup turned = s;
  reverse_faces(turned, found.reversed);
  for (const SoupDefect& defect : find_defects(turned))
    if (defect.kind == SoupDefectKind::inconsistent_orientation)
      CHECK_FALSE(found.pieces[found.piece[defect.faces[0]]].orientable);
  for (std::size_t f = 0; f < s.faces(); ++f)
    if (!s.face(f).empty()) CHECK(turned.face(f).front() == s.face(f).front());
}

}  // namespace

TEST_SUITE("orient") {
  TEST_CASE("pieces are those of the report, and as few faces as possible are reversed") {
    std::mt19937 random(29);
    for (int i = 0; i < 300; ++i) check_orientation(random_soup(random));
    for (int i = 0; i < 100; ++i) check_orientation(broken_surface(random));
  }

  TEST_CASE("reversed faces of a torus are found, and a Klein bottle is left as it is") {
    PolygonSoup torus = grid_soup(5, 4, true, true);
    const PolygonSoup whole = torus;
    std::vector<bool> some(torus.faces(), false);
    for (const std::size_t f : {1U, 7U, 8U, 20U}) some[f] = true;
    reverse_faces(torus, some);
    CHECK(orient(torus).reversed == some);
    reverse_faces(torus, orient(torus).reversed);
    CHECK(torus.corners == whole.corners);
    CHECK(orient(torus).pieces[0].closed);
    const Orientation bottle = orient(klein_bottle());
    REQUIRE(bottle.pieces.size() == 1);
    CHECK(bottle.pieces[0].closed);
    CHECK_FALSE(bottle.pieces[0].orientable);
    CHECK(std::count(bottle.reversed.begin(), bottle.reversed.end(), true) == 0);
  }

  TEST_CASE("wrong calls are refused") {
    PolygonSoup s = grid_soup(3, 3, false, false);
    CHECK_THROWS_AS(reverse_faces(s, std::vector<bool>(s.faces() + 1)), ContractViolation);
    s.begin.back() += 1;
    CHECK_THROWS_AS(orient(s), ContractViolation);
  }
}
