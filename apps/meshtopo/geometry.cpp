#include "meshtopo/geometry.h"

#include <algorithm>
#include <utility>

#include "io/interrupt.h"
#include "io/mesh/equal_positions.h"
#include "io/mesh/write_mesh.h"
#include "io/mesh/zero_area.h"
#include "io/sort.h"
#include "rbpa/space/repair/crossing_triangles.h"

namespace rbpa::app {
namespace {

using Face = std::span<const std::uint32_t>;

bool names_each_once(Face face, std::vector<std::uint32_t>& scratch) {
  if (face.size() == 3) return face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
  scratch.assign(face.begin(), face.end());
  std::sort(scratch.begin(), scratch.end());
  return std::adjacent_find(scratch.begin(), scratch.end()) == scratch.end();
}

void find_zero_areas(const MeshFile& mesh, std::vector<GeometricDefect>& defects) {
  std::vector<std::uint32_t> scratch;
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f) {
    if (f % 16384 == 0) stop_if_interrupted();
    const Face face = mesh.soup.face(f);
    if (face.size() >= 3 && names_each_once(face, scratch) && is_on_a_line(face, mesh.positions))
      defects.push_back({GeometryKind::zero_area_face, {face.begin(), face.end()}, {f}});
  }
}

void find_coincident(const MeshFile& mesh, std::vector<GeometricDefect>& defects) {
  EqualPositions places(mesh.positions.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      repeated;  // the first vertex at a position, and a later vertex at this position
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    if (const std::uint32_t first = places.first_at(mesh.positions, i); first != i) repeated.emplace_back(first, i);
  }
  sort(repeated);
  for (std::size_t k = 0; k < repeated.size(); ++k) {
    if (k % 16384 == 0) stop_if_interrupted();
    const auto& [first, later] = repeated[k];
    if (k == 0 || repeated[k - 1].first != first) defects.push_back({GeometryKind::coincident_vertices, {first}, {}});
    defects.back().points.push_back(later);
  }
}

}  // namespace

std::string_view name(GeometryKind kind) {
  return kind == GeometryKind::zero_area_face ? "zero-area face" : "coincident vertices";
}

std::vector<GeometricDefect> find_geometric_defects(const MeshFile& mesh) {
  std::vector<GeometricDefect> defects;
  find_zero_areas(mesh, defects);
  find_coincident(mesh, defects);
  return defects;
}

std::size_t count_crossings(const MeshFile& mesh, std::size_t most) {
  const TriangulatedFaces faces(mesh.positions, mesh.soup);
  std::vector<std::uint32_t> face_of;
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f)
    for (std::size_t corner = 2; corner < mesh.soup.face(f).size(); ++corner)
      face_of.push_back(static_cast<std::uint32_t>(f));
  const GoOn go_on = until_interrupted();
  auto pairs =
      crossing_triangles(faces.vertices, faces.triangles, most, {.progress = [&](const auto&) { return go_on(); }});
  for (auto& [one, other] : pairs) {
    one = face_of[one];
    other = face_of[other];
  }
  std::erase_if(pairs, [](const auto& pair) { return pair.first == pair.second; });
  sort(pairs);
  return static_cast<std::size_t>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

}  // namespace rbpa::app
