// Compares the topology of meshes and soups with CGAL's Polygon Mesh Processing.
//   --count=N   number of random soups of each kind
#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <map>
#include <numeric>
#include <string>

#include "meshops/core/validate.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/repair.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "oracle/cgal_topology.h"
#include "oracle/read_off.h"
#include "support/arguments.h"
#include "support/data_folder.h"
#include "support/random.h"

namespace rbpa_test {
namespace {

using meshops::PolygonSoup;
using meshops::SoupDefectKind;

std::string text_of(const PolygonSoup& soup) {
  std::string text = std::to_string(soup.points) + " points";
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    text += ',';
    for (const std::uint32_t corner : soup.face(f)) text += ' ' + std::to_string(corner);
  }
  return text;
}

/// Returns a form that is equal for every way to write a cycle, in either direction.
std::vector<std::uint32_t> undirected(std::vector<std::uint32_t> cycle) {
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  if (cycle.size() > 1 && cycle[1] > cycle.back()) std::reverse(cycle.begin() + 1, cycle.end());
  return cycle;
}

bool has(const PolygonSoup& soup, SoupDefectKind kind) {
  const auto defects = meshops::find_defects(soup);
  return std::any_of(defects.begin(), defects.end(), [&](const auto& defect) { return defect.kind == kind; });
}

std::vector<CgalPiece> pieces_of(const meshops::TopologyReport& report) {
  std::vector<CgalPiece> pieces;
  for (const meshops::ComponentReport& piece : report.per_component)
    pieces.push_back({piece.vertices, piece.edges, piece.faces, piece.boundary_curves, piece.genus().value_or(-1)});
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

/// Checks the report of a soup and of its mesh, piece by piece. Requires: a soup without defects.
void check_pieces(const PolygonSoup& soup) {
  const std::vector<CgalPiece> expected = cgal_pieces(soup);
  CHECK(pieces_of(meshops::report(soup)) == expected);
  OpenMesh::PolyMesh_ArrayKernelT<> mesh;
  meshops::build_mesh(mesh, soup);
  CHECK(meshops::validate(mesh).empty());
  CHECK(pieces_of(meshops::report(mesh)) == expected);
}

PolygonSoup grid(std::uint32_t columns, std::uint32_t rows, bool closed_x, bool closed_y, bool twisted) {
  const std::uint32_t nx = columns + (closed_x ? 0 : 1), ny = rows + (closed_y ? 0 : 1);
  PolygonSoup soup;
  soup.points = std::size_t{nx} * ny;
  const auto at = [&](std::uint32_t x, std::uint32_t y) {
    if (twisted && x == nx) y = (closed_y ? rows : rows + 1) - 1 - y % ny;
    return y % ny * nx + x % nx;
  };
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::vector<std::uint32_t> square = {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)};
      if ((x + y) % 3 == 0) {
        soup.add_face(square);
      } else {
        soup.add_face(std::vector{square[0], square[1], square[2]});
        soup.add_face(std::vector{square[0], square[2], square[3]});
      }
    }
  return soup;
}

/// Returns two surfaces side by side, with faces missing or reversed and some points merged.
PolygonSoup random_surfaces(Random& random, bool twisted) {
  PolygonSoup soup;
  std::vector<std::vector<std::uint32_t>> faces;
  for (int part = 0; part < 2; ++part) {
    const bool closed_x = twisted || random.chance(0.5);
    const PolygonSoup one =
        grid(static_cast<std::uint32_t>(random.integer(3, 7)), static_cast<std::uint32_t>(random.integer(3, 6)),
             closed_x, random.chance(0.5), twisted && random.chance(0.5));
    for (std::size_t f = 0; f < one.faces(); ++f) {
      if (random.chance(0.1)) continue;
      std::vector<std::uint32_t> face;
      for (const std::uint32_t corner : one.face(f)) face.push_back(corner + static_cast<std::uint32_t>(soup.points));
      if (random.chance(0.1)) std::reverse(face.begin(), face.end());
      faces.push_back(std::move(face));
    }
    soup.points += one.points;
  }
  std::vector<std::uint32_t> name(soup.points);
  std::iota(name.begin(), name.end(), 0U);
  for (int merged = random.integer(0, 6); merged > 0; --merged)
    name[random.below(soup.points)] = static_cast<std::uint32_t>(random.below(soup.points));
  random.shuffle(faces);
  for (std::vector<std::uint32_t>& face : faces) {
    for (std::uint32_t& corner : face) corner = name[corner];
    soup.add_face(face);
  }
  return soup;
}

/// Returns faces of any kind on few points: most edges have too many faces.
PolygonSoup random_faces(Random& random) {
  PolygonSoup soup;
  soup.points = 4 + random.below(8);
  for (std::uint64_t left = 1 + random.below(2 * soup.points); left > 0; --left) {
    std::vector<std::uint32_t> corners(soup.points);
    std::iota(corners.begin(), corners.end(), 0U);
    random.shuffle(corners);
    corners.resize(random.chance(0.8) ? 3 : 4);
    soup.add_face(corners);
  }
  return soup;
}

/// Returns the soup without the faces that CGAL does not accept: degenerate and repeated ones.
PolygonSoup with_whole_faces(const PolygonSoup& soup) {
  std::vector<bool> bad(soup.faces(), false);
  for (const meshops::SoupDefect& defect : meshops::find_defects(soup))
    if (defect.kind <= SoupDefectKind::duplicate_face) bad[defect.faces.back()] = true;
  PolygonSoup kept;
  kept.points = soup.points;
  for (std::size_t f = 0; f < soup.faces(); ++f)
    if (!bad[f]) kept.add_face(soup.face(f));
  return kept;
}

template <typename Check>
void for_each_random_soup(Check check) {
  Random random(20100117);
  for (std::uint64_t i = 0; i < argument("count", 1000); ++i)
    for (const PolygonSoup& soup :
         {random_surfaces(random, false), random_surfaces(random, true), random_faces(random)}) {
      const PolygonSoup whole = with_whole_faces(soup);
      INFO(text_of(whole));
      check(whole);
    }
}

/// Published facts about the mesh files: V, F, curves, genus; each is one piece.
struct Known {
  std::size_t vertices, faces, curves;
  long genus;
};
const std::map<std::string, Known>& known_meshes() {
  static const std::map<std::string, Known> known = {{"m3_bob", {250, 500, 0, 1}},
                                                     {"m3_cube_no_bottom", {25, 40, 1, 0}},
                                                     {"m3_human_woman", {6890, 13776, 0, 0}},
                                                     {"m3_plane_holes", {8519, 16747, 27, 0}},
                                                     {"m3_plate_holes", {618, 1252, 0, 5}},
                                                     {"m3_quadknot", {1440, 2880, 0, 1}},
                                                     {"m3_spot", {829, 1654, 0, 0}},
                                                     {"m3_torus", {2304, 4608, 0, 1}},
                                                     {"m3_wingnut", {3047, 6090, 0, 0}}};
  return known;
}

/// Checks the meshes of a folder. Returns: their number.
std::size_t check_meshes(const std::filesystem::path& folder) {
  const std::vector<MeshFile> files = mesh_files(folder);
  for (const MeshFile& file : files) {
    INFO(file.name);
    const PolygonSoup soup = read_off(file);
    CHECK(meshops::find_defects(soup).empty());
    CHECK(cgal_takes(soup));
    check_pieces(soup);
    const auto slot = known_meshes().find(file.name);
    if (slot == known_meshes().end()) continue;
    const Known& known = slot->second;
    const meshops::TopologyReport report = meshops::report(soup);
    CHECK(report.vertices == known.vertices);
    CHECK(report.faces == known.faces);
    CHECK(report.components == 1);
    CHECK(report.boundary_curves == known.curves);
    CHECK(report.genus == known.genus);
    CHECK(report.euler() == 2 - 2 * known.genus - static_cast<long>(known.curves));
  }
  return files.size();
}

TEST_CASE("bundled meshes have the published numbers, and the pieces that CGAL finds") {
  CHECK(check_meshes(bundled_data()) >= 5);
}

TEST_CASE("further meshes have the published numbers, and the pieces that CGAL finds") {
  CHECK((check_meshes(further_data()) > 0) == has_further_data());
}

TEST_CASE("damaged meshes from files have, after repair, the pieces that CGAL's orientation gives") {
  Random random(7);
  for (const auto& folder : {further_data(), bundled_data()})
    for (const MeshFile& file : mesh_files(folder)) {
      INFO(file.name);
      PolygonSoup soup = read_off(file);
      for (std::uint32_t& corner : soup.corners)
        if (random.chance(0.001)) corner = static_cast<std::uint32_t>(random.below(soup.points));
      for (std::size_t f = 0; f < soup.faces(); ++f)
        if (random.chance(0.2))
          std::reverse(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin[f]),
                       soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin[f + 1]));
      const PolygonSoup whole = with_whole_faces(soup);
      const PolygonSoup repaired = meshops::repair(whole).soup;
      CHECK(cgal_takes(repaired));
      check_pieces(repaired);
      if (!has(whole, SoupDefectKind::not_orientable)) {
        const PolygonSoup oriented = cgal_oriented(whole);
        CHECK(repaired.points == oriented.points);
        CHECK(pieces_of(meshops::report(repaired)) == cgal_pieces(oriented));
      }
    }
}

TEST_CASE("a soup has no defects exactly when CGAL accepts it as a mesh") {
  std::size_t taken = 0;
  for_each_random_soup([&](const PolygonSoup& soup) {
    CHECK(meshops::find_defects(soup).empty() == cgal_takes(soup));
    taken += cgal_takes(soup);
  });
  CHECK(taken > 0);
}

TEST_CASE("a repaired soup is a mesh to CGAL, with the same pieces") {
  for_each_random_soup([&](const PolygonSoup& soup) {
    const PolygonSoup repaired = meshops::repair(soup).soup;
    REQUIRE(cgal_takes(repaired));
    check_pieces(repaired);
  });
}

TEST_CASE("repair splits points as CGAL's orientation does, if directions can agree") {
  std::size_t compared = 0;
  for_each_random_soup([&](const PolygonSoup& soup) {
    // If a surface is not orientable, each library cuts it by its own order of faces.
    if (has(soup, SoupDefectKind::not_orientable)) return;
    ++compared;
    const PolygonSoup repaired = meshops::repair(soup).soup, oriented = cgal_oriented(soup);
    CHECK(repaired.points == oriented.points);
    CHECK(pieces_of(meshops::report(repaired)) == cgal_pieces(oriented));
  });
  CHECK(compared > argument("count", 1000));
}

TEST_CASE("the faces that repair keeps are those that CGAL keeps") {
  // CGAL makes two faces of a face that returns to a point, and repair() drops it: such faces are left out.
  const auto comes_back = [](std::vector<std::uint32_t> face) {
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    std::sort(face.begin(), face.end());
    return std::adjacent_find(face.begin(), face.end()) != face.end();
  };
  Random random(41);
  std::size_t dropped = 0;
  for (std::uint64_t i = 0; i < argument("count", 1000); ++i) {
    PolygonSoup soup;
    soup.points = 3 + random.below(4);
    for (std::uint64_t left = random.below(12); left > 0; --left) {
      std::vector<std::uint32_t> face(random.below(6));
      for (std::uint32_t& corner : face) corner = static_cast<std::uint32_t>(random.below(soup.points));
      if (!comes_back(face)) soup.add_face(face);
    }
    INFO(text_of(soup));
    const meshops::Repair repaired = meshops::repair(soup);
    std::vector<std::vector<std::uint32_t>> kept, expected = cgal_kept_faces(soup);
    for (std::size_t f = 0; f < repaired.soup.faces(); ++f) {
      kept.emplace_back();
      for (const std::uint32_t corner : repaired.soup.face(f)) kept.back().push_back(repaired.stands_on[corner]);
    }
    for (auto* faces : {&kept, &expected}) {
      for (std::vector<std::uint32_t>& face : *faces) face = undirected(face);
      std::sort(faces->begin(), faces->end());
    }
    CHECK(kept == expected);
    dropped += soup.faces() - kept.size();
  }
  CHECK(dropped > 0);
}

TEST_CASE("pinches are the vertices with several umbrellas") {
  std::size_t found = 0;
  for_each_random_soup([&](const PolygonSoup& soup) {
    const meshops::Repair repaired = meshops::repair(soup);
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    meshops::build_mesh(mesh, repaired.soup);
    const CgalPinches expected = cgal_pinches(repaired.soup, repaired.stands_on);
    CHECK(meshops::report(mesh, repaired.stands_on).pinches == expected.points);
    CHECK(repaired.soup.points - soup.points == expected.copies);
    found += expected.points;
  });
  CHECK(found > 0);
}

}  // namespace
}  // namespace rbpa_test
