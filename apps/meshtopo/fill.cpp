#include "meshtopo/fill.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "io/interrupt.h"
#include "meshops/core/disjoint_sets.h"
#include "meshops/topology/merge_points.h"
#include "meshops/topology/repair.h"
#include "meshops/topology/soup_defects.h"
#include "meshtopo/face_fans.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/surface/surface_components.h"

namespace rbpa::app {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Returns the mean of the positions of `corners`, which does not depend on the order of the corners.
Point3 mean_of(std::span<const std::uint32_t> corners, std::span<const Point3> points) {
  const auto mean = [&](double Point3::*coordinate) {
    std::vector<double> shares;
    for (const std::uint32_t corner : corners)
      shares.push_back(points[corner].*coordinate / static_cast<double>(corners.size()));
    std::sort(shares.begin(), shares.end());
    return std::accumulate(shares.begin(), shares.end(), 0.0);
  };
  return {mean(&Point3::x), mean(&Point3::y), mean(&Point3::z)};
}

/// The obstacles to new triangles: the faces; a face of more corners as triangles around the mean of its corners.
struct Obstacles {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
};

Obstacles obstacles_of(const meshops::PolygonSoup& soup, const std::vector<Point3>& points) {
  Obstacles obstacles{.points = points, .triangles = {}};
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    if (f % 16384 == 0) stop_if_interrupted();
    const std::span<const std::uint32_t> face = soup.face(f);
    if (face.size() == 3) {
      obstacles.triangles.push_back({face[0], face[1], face[2]});
      continue;
    }
    const auto mean = static_cast<std::uint32_t>(obstacles.points.size());
    obstacles.points.push_back(mean_of(face, points));
    for (std::size_t i = 0; i < face.size(); ++i)
      obstacles.triangles.push_back({face[i], face[(i + 1) % face.size()], mean});
  }
  return obstacles;
}

/// Returns the chosen boundary curves as lists of vertices. Counts the other curves, by kind, in `not_chosen`.
std::vector<std::vector<std::uint32_t>> chosen_loops(const FaceFans& fans, std::span<const std::uint32_t> stands_on,
                                                     const CurveChoice& choice,
                                                     std::array<std::size_t, 3>& not_chosen) {
  const std::vector<Hole> curves = surface_curves(fans.points, fans.surface, until_interrupted());
  const std::vector<CurveKind> kinds =
      curve_kinds(fans.points, surface_components(fans.points, fans.surface, until_interrupted()), curves);
  std::vector<std::vector<std::uint32_t>> loops;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    std::vector<std::uint32_t> loop, points;
    for (const RimEdge& edge : curves[i].edges) {
      loop.push_back(edge.from);
      points.push_back(stands_on[edge.from]);
    }
    if (choice(curves[i], kinds[i], points))
      loops.push_back(std::move(loop));
    else
      ++not_chosen[static_cast<std::size_t>(kinds[i])];
  }
  return loops;
}

bool is_surface(const meshops::PolygonSoup& soup) {
  const std::vector<meshops::SoupDefect> defects = meshops::find_defects(soup, until_interrupted());
  return std::all_of(defects.begin(), defects.end(),
                     [](const auto& defect) { return defect.kind == meshops::SoupDefectKind::pinch; });
}

}  // namespace

FilledMesh fill(const MeshFile& mesh, const CurveChoice& choice) {
  const meshops::Repair parts = meshops::repair(mesh.soup, until_interrupted());  // has a vertex for each fan
  FilledMesh result{.mesh = {.positions = mesh.positions, .soup = mesh.soup, .point_lines = {}, .face_lines = {}},
                    .point_was = std::vector<std::uint32_t>(mesh.positions.size()),
                    .report = {}};
  std::iota(result.point_was.begin(), result.point_was.end(), 0U);
  const FaceFans fans(parts, mesh.positions);
  const std::vector<std::vector<std::uint32_t>> loops =
      chosen_loops(fans, parts.stands_on, choice, result.report.not_chosen);
  if (loops.empty()) return result;
  const Obstacles obstacles = obstacles_of(parts.soup, fans.points);
  const GoOn go_on = until_interrupted();
  const HoleFilling filling =
      fill_holes(obstacles.points, obstacles.triangles, loops, {.progress = on_progress_of(go_on)});
  result.report.counts = count(filling.loops);

  meshops::DisjointSets sets(mesh.positions.size());
  const auto point_of = [&](std::uint32_t vertex) { return parts.stands_on[vertex]; };
  for (std::size_t t = 0; t < filling.triangles.size(); ++t) {
    const Triangle& corners = filling.triangles[t];
    if (t >= obstacles.triangles.size()) {
      const Triangle face = {point_of(corners[0]), point_of(corners[1]), point_of(corners[2])};
      result.mesh.soup.add_face(face);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k)
      if (corners[k] != obstacles.triangles[t][k]) sets.join(point_of(corners[k]), point_of(obstacles.triangles[t][k]));
  }
  std::vector<std::uint32_t> least(mesh.positions.size());
  for (std::uint32_t p = 0; p < least.size(); ++p) least[p] = sets.find(p);
  meshops::MergedPoints merged = meshops::merge_points(result.mesh.soup, least, until_interrupted());
  result.report.merged = merged.merged;
  result.mesh.soup = std::move(merged.soup);
  result.point_was = std::move(merged.point_was);
  // Cut edges with more than two faces: merging vertices can make edges coincide.
  if (!is_surface(result.mesh.soup)) {
    meshops::Repair again = meshops::repair(result.mesh.soup, until_interrupted());
    result.mesh.soup = std::move(again.soup);
    for (std::uint32_t& p : again.stands_on) p = result.point_was[p];
    result.point_was = std::move(again.stands_on);
  }
  result.mesh.positions.clear();
  for (const std::uint32_t p : result.point_was) result.mesh.positions.push_back(mesh.positions[p]);
  return result;
}

}  // namespace rbpa::app
