// What: runs the rounds of a remeshing: splits long edges, collapses short ones, flips edges toward six at a vertex,
//       and moves vertices along the surface.
// Law:  that of remesh() (remesh.h), if the numbers of vertices, edges and faces of the given mesh are canonical: the
//       result depends on these numbers.
#pragma once

#include <optional>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/core/progress.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/simplify/distance/surface_distance.h"
#include "rbpa/space/simplify/remesh.h"
#include "rbpa/space/simplify/remeshing/mesh_curves.h"

namespace rbpa::space {

class RemeshRun {
 public:
  /// Keeps references to all arguments but `curves` and `wanted`, which are those of the mesh, from wanted_lengths().
  /// `given` has the triangles of the mesh at the time of the call.
  RemeshRun(meshops::Connectivity& mesh, std::vector<Point3>& places, MeshCurves curves, std::vector<double> wanted,
            const SurfaceDistance& given, const RemeshOptions& options, Remeshing& counts);

  /// Runs all rounds: changes mesh, places and counts. Deleted elements stay marked. Throws: Cancelled.
  void operator()();

 private:
  using Edge = meshops::Edge;
  using Halfedge = meshops::Halfedge;
  using Vertex = meshops::Vertex;
  /// A place of a vertex, and the length that edges there should have, as a part of options.length.
  struct Target {
    Point3 place;
    double wanted;
  };

  void split_long();
  void collapse_short();
  void flip_to_regular();
  void move_vertices(bool onto_given);

  bool try_split(Edge e);
  std::optional<Vertex> try_collapse(Edge e);
  std::optional<Target> middle_of(Halfedge h) const;
  bool may_collapse(Halfedge h, const Target& target) const;
  bool try_flip(Edge e, std::vector<int>& excess);
  bool may_move(Vertex v, const Point3& place) const;
  bool is_near(const SurfaceDistance::Corners& triangle) const;
  bool is_near_curve(Edge e, const SurfaceDistance::Corners& segment) const;
  std::optional<Target> target(Vertex v, bool onto_given) const;
  std::optional<Target> along_surface(Vertex v, bool onto_given) const;
  std::optional<Target> on_curve(const Target& target, int curve) const;
  Target at_foot(const SurfaceDistance::Foot& foot) const;

  bool is_kept(Edge e) const { return options_.keep_boundary && mesh_.is_boundary(e); }
  const Point3& at(Vertex v) const { return places_[static_cast<std::size_t>(v.idx())]; }
  const Point3& at_end(Halfedge h) const { return at(mesh_.to_vertex_handle(h)); }
  double wanted(Vertex v) const { return wanted_.empty() ? 1 : wanted_[static_cast<std::size_t>(v.idx())]; }
  double squared_length(Edge e) const;
  void move(Vertex v, const Target& target);
  Point3 rounded(const Point3& p) const;

  meshops::Connectivity& mesh_;
  std::vector<Point3>& places_;
  const SurfaceDistance& given_;
  const RemeshOptions& options_;
  Remeshing& counts_;
  MeshCurves curves_;
  const std::vector<double> given_wanted_;  // wanted_ of the given mesh
  std::vector<double> wanted_;              // wanted_lengths(), for the vertices as they are
  const double long_, short_;  // squared lengths above and below which an edge is split and collapsed, respectively
  meshops::Steps step_;
};

}  // namespace rbpa::space
