#include "meshtopo/edits.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "io/interrupt.h"
#include "io/mesh/fan_triangles.h"
#include "meshops/topology/keep_faces.h"
#include "meshops/topology/merge_points.h"
#include "meshops/topology/orient.h"
#include "meshops/topology/repair.h"
#include "meshtopo/exact.h"
#include "meshtopo/face_fans.h"
#include "rbpa/space/surface/outer_shells.h"
#include "rbpa/space/surface/surface_components.h"

namespace rbpa::app {
namespace {

/// Returns whether `a` is lexicographically less than `b`. −0 counts as less than +0, so that the least of several
/// positions is unique even if they are equal as numbers.
bool is_before(const Position& a, const Position& b) {
  const auto key = [](const Position& p) {
    return std::tuple(p[0], p[1], p[2], !std::signbit(p[0]), !std::signbit(p[1]), !std::signbit(p[2]));
  };
  return key(a) < key(b);
}

void renumber(EditedMesh& edited, meshops::SoupPart& part) {
  edited.mesh.soup = std::move(part.soup);
  for (std::uint32_t& p : part.point_was) p = edited.point_was[p];
  for (std::size_t& f : part.face_was) f = edited.face_was[f];
  edited.point_was = std::move(part.point_was);
  edited.face_was = std::move(part.face_was);
}

void weld(EditedMesh& edited, double distance) {
  const std::vector<std::uint32_t> least = near_vertices(edited.mesh.positions, distance);
  std::vector<Position> places = edited.mesh.positions;
  for (std::uint32_t p = 0; p < places.size(); ++p)
    if (is_before(edited.mesh.positions[p], places[least[p]])) places[least[p]] = edited.mesh.positions[p];
  meshops::MergedPoints merged = meshops::merge_points(edited.mesh.soup, least, until_interrupted());
  edited.mesh.positions.clear();
  for (const std::uint32_t p : merged.point_was) edited.mesh.positions.push_back(places[p]);
  edited.report.weld = {.distance = distance,
                        .vertices = merged.merged,
                        .corners = merged.corners,
                        .degenerate_faces = merged.degenerate,
                        .duplicate_faces = merged.duplicate};
  renumber(edited, merged);
}

struct KeptComponents {
  std::vector<bool> faces;  ///< whether each face is kept; degenerate and repeated faces are not
  std::size_t dropped = 0;  ///< number of dropped components
};

/// Returns the faces of the chosen components. Faces that share an edge are in one component. As in `rbpa surface`, a
/// face of n corners counts as n − 2 triangles. The choice does not depend on the order of vertices and faces.
/// Requires: `choice` is not restricted to outer shells. Cost: that of meshops::repair(), and O(n log n).
KeptComponents kept_components(const MeshFile& mesh, const ComponentChoice& choice) {
  // Repair first: a repair makes the faces of each component agree in direction, and splits no component.
  const meshops::Repair repaired = meshops::repair(mesh.soup, until_interrupted());
  const FaceFans fans(repaired, mesh.positions);
  const SurfaceComponents components = surface_components(fans.points, fans.surface, until_interrupted());
  const std::vector<bool> kept = choose_components(components, {}, choice);
  KeptComponents result;
  result.faces.assign(mesh.soup.faces(), false);
  for (std::size_t t = 0; t < fans.face.size(); ++t)
    if (kept[components.number[t]]) result.faces[repaired.face_was[fans.face[t]]] = true;
  result.dropped = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
  return result;
}

void drop(EditedMesh& edited, const ComponentChoice& choice) {
  const KeptComponents kept = kept_components(edited.mesh, choice);
  const std::size_t faces = edited.mesh.soup.faces(), vertices = edited.mesh.soup.points;
  meshops::SoupPart part = meshops::keep_faces(edited.mesh.soup, kept.faces, until_interrupted());
  edited.report.drop = {
      .components = kept.dropped, .faces = faces - part.face_was.size(), .vertices = vertices - part.point_was.size()};
  std::vector<Position> places;
  for (const std::uint32_t p : part.point_was) places.push_back(edited.mesh.positions[p]);
  edited.mesh.positions = std::move(places);
  renumber(edited, part);
}

/// Returns for each component that is closed and orientable the triangles of its faces, which agree in direction; for
/// any other component an empty list.
std::vector<std::vector<Triangle>> triangles_by_piece(const MeshFile& mesh, const meshops::Orientation& orientation) {
  std::vector<std::vector<Triangle>> triangles(orientation.pieces.size());
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f) {
    if (f % 16384 == 0) stop_if_interrupted();
    const std::uint32_t piece = orientation.piece[f];
    if (piece == meshops::Orientation::none || !orientation.pieces[piece].closed ||
        !orientation.pieces[piece].orientable)
      continue;
    for_each_fan_triangle(mesh.soup.face(f), mesh.positions, [&](Triangle triangle) {
      if (orientation.reversed[f]) std::swap(triangle[1], triangle[2]);
      triangles[piece].push_back(triangle);
    });
  }
  return triangles;
}

void orient(EditedMesh& edited) {
  meshops::Orientation orientation = meshops::orient(edited.mesh.soup, until_interrupted());
  std::vector<bool> to_reverse(orientation.pieces.size(), false);
  Oriented report;
  std::vector<std::vector<Triangle>> triangles = triangles_by_piece(edited.mesh, orientation);
  std::vector<int> signs;
  for (std::size_t p = 0; p < triangles.size(); ++p) {
    if (!orientation.pieces[p].orientable)
      report.not_orientable.push_back(edited.face_was[orientation.pieces[p].first_face]);
    signs.push_back(volume_sign(edited.mesh.positions, triangles[p]));
    if (signs.back() == 0) triangles[p].clear();
  }
  std::vector<Point3> points;
  for (const auto& [x, y, z] : edited.mesh.positions) points.push_back({x, y, z});
  const std::vector<std::size_t> depth = nesting_depths(points, triangles, until_interrupted());
  for (std::size_t p = 0; p < triangles.size(); ++p) {
    if (signs[p] == 0) continue;
    const bool is_wall_of_cavity = depth[p] % 2 == 1;
    ++(is_wall_of_cavity ? report.inward : report.outward);
    report.nested += depth[p] > 0;
    to_reverse[p] = is_wall_of_cavity == (signs[p] > 0);
  }
  for (std::size_t f = 0; f < edited.mesh.soup.faces(); ++f) {
    const std::uint32_t piece = orientation.piece[f];
    if (piece != meshops::Orientation::none && to_reverse[piece]) orientation.reversed[f].flip();
    report.faces += orientation.reversed[f];
  }
  meshops::reverse_faces(edited.mesh.soup, orientation.reversed);
  edited.report.orient = std::move(report);
}

}  // namespace

EditedMesh edit(const MeshFile& mesh, const Edits& edits) {
  EditedMesh edited;
  edited.mesh.positions = mesh.positions;
  edited.mesh.soup = mesh.soup;
  edited.point_was.resize(mesh.positions.size());
  edited.face_was.resize(mesh.soup.faces());
  std::iota(edited.point_was.begin(), edited.point_was.end(), 0U);
  std::iota(edited.face_was.begin(), edited.face_was.end(), std::size_t{0});
  if (edits.weld) weld(edited, *edits.weld);
  if (!edits.components.keeps_all()) drop(edited, edits.components);
  if (edits.orient) orient(edited);
  return edited;
}

}  // namespace rbpa::app
