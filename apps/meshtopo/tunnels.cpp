#include "meshtopo/tunnels.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "io/interrupt.h"
#include "meshops/topology/keep_faces.h"
#include "meshops/topology/report.h"
#include "meshtopo/fill.h"
#include "meshtopo/generators.h"

namespace rbpa::app {
namespace {

using meshops::PolygonSoup;

/// Returns for each face whether a point of the loop is a corner of the face.
std::vector<bool> faces_at(const PolygonSoup& soup, const Polyline& loop) {
  std::vector<bool> is_on_loop(soup.points, false), at(soup.faces(), false);
  for (const std::uint32_t p : loop) is_on_loop[p] = true;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    if (f % 16384 == 0) stop_if_interrupted();
    const auto face = soup.face(f);
    at[f] = std::any_of(face.begin(), face.end(), [&](std::uint32_t p) { return is_on_loop[p]; });
  }
  return at;
}

std::size_t count_of(const std::vector<bool>& which) {
  return static_cast<std::size_t>(std::count(which.begin(), which.end(), true));
}

class Closing {
 public:
  Closing(const MeshFile& mesh, double below) : below_(below) {
    result_.mesh.positions = mesh.positions;
    result_.mesh.soup = mesh.soup;
    result_.point_was.resize(mesh.positions.size());
    std::iota(result_.point_was.begin(), result_.point_was.end(), 0U);
    topology_ = meshops::report(mesh.soup, until_interrupted());
  }

  SimplerMesh run() {
    while (round()) {
    }
    return std::move(result_);
  }

 private:
  /// Closes loops one after another, unless a face at the loop was removed in this round: closing one loop then does
  /// not change another. Returns whether a loop was closed.
  bool round() {
    result_.report.left = 0;
    std::size_t closed = 0;
    std::vector<bool> is_taken(result_.mesh.soup.points,
                               false);  // true for points of faces that this round has removed
    for (const Polyline& loop : shortest_generators(result_.mesh.soup, result_.mesh.positions, below_)) {
      std::vector<std::uint32_t> places;  // numbers in the given mesh, which no round changes
      for (const std::uint32_t p : loop) places.push_back(result_.point_was[p]);
      std::sort(places.begin(), places.end());
      const bool is_free = std::none_of(loop.begin(), loop.end(), [&](std::uint32_t p) { return is_taken[p]; });
      if (failed_.contains(places) || !is_free) {
        ++result_.report.left;
      } else if (close(loop, is_taken)) {
        ++closed;
      } else {
        failed_.insert(std::move(places));
        ++result_.report.left;
      }
    }
    result_.report.closed += closed;
    if (closed > 0) drop_points();
    return closed > 0;
  }

  bool close(const Polyline& loop, std::vector<bool>& is_taken) {
    const PolygonSoup& soup = result_.mesh.soup;
    const std::vector<bool> gone = faces_at(soup, loop);
    MeshFile open;
    open.positions = result_.mesh.positions;
    open.soup.points = soup.points;
    std::vector<bool> is_around(soup.points, false);
    for (std::size_t f = 0; f < soup.faces(); ++f) {
      if (!gone[f]) open.soup.add_face(soup.face(f));
      if (gone[f])
        for (const std::uint32_t p : soup.face(f)) is_around[p] = true;
    }
    // Choose the new holes: all their points are corners of removed faces. An older hole has other points, or is
    // unchanged.
    FilledMesh filled = fill(open, [&](const Hole&, CurveKind, std::span<const std::uint32_t> points) {
      return std::all_of(points.begin(), points.end(), [&](std::uint32_t p) { return is_around[p]; });
    });
    if (filled.report.counts.left() > 0 || filled.report.merged > 0) return false;
    if (filled.mesh.soup.points != soup.points) return false;  // the filling has split a vertex
    meshops::TopologyReport topology = meshops::report(filled.mesh.soup, until_interrupted());
    if (!is_simpler(topology)) return false;
    topology_ = std::move(topology);
    result_.report.removed += count_of(gone);
    result_.report.added += filled.report.counts.triangles;
    result_.mesh.soup = std::move(filled.mesh.soup);
    for (std::uint32_t p = 0; p < is_taken.size(); ++p) is_taken[p] = is_taken[p] || is_around[p];
    return true;
  }

  bool is_simpler(const meshops::TopologyReport& topology) const {
    return topology.genus && topology_.genus && *topology.genus == *topology_.genus - 1 &&
           topology.solid_components == topology_.solid_components &&
           topology.boundary_curves == topology_.boundary_curves && topology.pinches <= topology_.pinches;
  }

  /// Removes points that had faces and now have none.
  void drop_points() {
    meshops::SoupPart part =
        meshops::keep_faces(result_.mesh.soup, std::vector<bool>(result_.mesh.soup.faces(), true), until_interrupted());
    std::vector<std::array<double, 3>> positions;
    for (std::uint32_t& p : part.point_was) {
      positions.push_back(result_.mesh.positions[p]);
      p = result_.point_was[p];
    }
    result_.mesh.positions = std::move(positions);
    result_.mesh.soup = std::move(part.soup);
    result_.point_was = std::move(part.point_was);
  }

  double below_;
  SimplerMesh result_;
  meshops::TopologyReport topology_;
  std::set<std::vector<std::uint32_t>> failed_;
};

}  // namespace

SimplerMesh close_tunnels(const MeshFile& mesh, double below) { return Closing(mesh, below).run(); }

}  // namespace rbpa::app
