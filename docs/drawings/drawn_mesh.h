// What: draws a mesh whose vertices have places in the plane.
// Law:  only what the mesh holds is drawn: its live faces, edges, vertices and boundary curves.
#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "drawings/canvas.h"
#include "meshops/core/live.h"

namespace figures {

using meshops::Edge;
using meshops::Face;
using meshops::Halfedge;
using meshops::Vertex;

struct PlaneTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
struct Mesh : OpenMesh::PolyMesh_ArrayKernelT<PlaneTraits> {
  Mesh() { meshops::request_status(*this); }
};

/// Mesh whose points are places. If it does not fit into the plane, a corner of a face may lie elsewhere than its
/// vertex: then an edge has a place on each side, and a vertex several.
struct DrawnMesh {
  Mesh mesh;
  std::map<Halfedge, Place> apart;  ///< the end of a halfedge as a corner of its face
  std::map<Edge, Place> bend;       ///< for edges that are not straight

  Place place(Vertex v) const { return {mesh.point(v)[0], mesh.point(v)[1]}; }
  void move(Vertex v, Place to) { mesh.set_point(v, {to.x, to.y, 0}); }
  void move(Vertex v, Vertex w, Place to) {
    move(v, to);
    move(w, to);
  }
  /// Returns the segment of a halfedge as a side of its face; for a boundary halfedge, that of its opposite, reversed.
  Segment segment(Halfedge h) const;
  Place centroid(Face f) const;
  /// Returns the halfedge from vertex to vertex. Throws when there is none.
  Halfedge between(int from, int to) const;
  /// Returns the boundary halfedge of the edge between two vertices. Throws when there is none.
  Halfedge boundary_between(int a, int b) const;
  std::vector<Place> all_places() const;
};

using Corners = std::vector<std::uint32_t>;

/// Returns a mesh of faces whose corners are places.
DrawnMesh drawn_mesh(const std::vector<Place>& places, const std::vector<Corners>& faces);

/// Ring of quadrangles, each cut in two, between two circles about the origin. From 0 to 360 degrees it closes. Places
/// 0, 1, … lie on the outer circle, followed by as many on the inner one.
struct Ring {
  std::vector<Place> places;
  std::vector<Corners> faces;
};
Ring ring(std::uint32_t quads, double from, double to, double inner_radius, double outer_radius);

/// Elements that a panel marks on the mesh.
struct Marks {
  std::set<Vertex> vertices;  ///< elements that the operator touches
  std::set<Edge> edges;
  std::set<Face> faces;
  struct Label {
    Place at;
    std::string words;
  };
  std::vector<Label> labels;
  void add(Vertex v) { vertices.insert(v); }
  void add(Edge e) { edges.insert(e); }
  void add(Face f) { faces.insert(f); }
};

/// Map from the plane of a mesh, y upwards, to the canvas.
struct Frame {
  Place origin;  ///< in pixels
  double scale;  ///< pixels per unit
  Place operator()(Place p) const { return {origin.x + scale * p.x, origin.y - scale * p.y}; }
  Segment of(const Segment& s) const {
    Segment mapped{(*this)(s.from), (*this)(s.to), {}};
    if (s.bend) mapped.bend = (*this)(*s.bend);
    return mapped;
  }
};

void draw(Canvas& canvas, const Frame& frame, const DrawnMesh& drawn, const Marks& marks);

}  // namespace figures
