// What: a model of a mesh as oriented faces only: each is a cycle of sides, each side with a name and a start vertex.
// Why:  the operators work on it by their definitions, without links: the boundary, fans and curves follow from the
//       faces. The library must leave the same mesh, and whatever it refuses must be bad.
#pragma once

#include <string>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/core/delta.h"

namespace meshops::test {

using Cycle = std::vector<int>;

/// Model of a mesh. Names are handles: side h and side h ^ 1 are the two sides of an edge; a side that is in no face is
/// on the boundary.
class Model {
 public:
  Model() = default;
  /// Takes the live faces, edges and vertices of a mesh.
  explicit Model(const Connectivity& mesh);

  std::vector<Cycle> faces;      ///< by name, from the least side on; empty if there is no such face
  std::vector<int> from;         ///< the vertex at which a side starts, -1 if there is no edge
  std::vector<char> has_vertex;  ///< by name
  friend bool operator==(const Model& a, const Model& b);

  bool has_side(int h) const { return in(h, from) && from[at(h)] >= 0; }
  bool has_face(int f) const { return in(f, faces) && !faces[at(f)].empty(); }
  int to(int h) const { return from[at(h ^ 1)]; }
  /// Returns the face of a side, -1 when there is none.
  int face_of(int h) const;
  bool is_boundary(int h) const { return face_of(h) < 0; }
  /// Returns the cycle of a face, from `first` on.
  Cycle cycle(int f, int first) const;
  void set_face(int f, Cycle cycle);
  /// Replaces a side by `heir` in its face, if it is in one.
  void replace(int side, int heir);
  void erase_edge(int h);
  void rename_vertex(int old, int name);
  void add_edge(int h, int start, int end);
  void add_vertex(int v);

  /// Returns all sides that leave a vertex.
  std::vector<int> leaving(int v) const;
  /// Returns the sides that leave a vertex, grouped by the corners of faces that join them: each fan counter-clockwise,
  /// and from the boundary on if it is open.
  std::vector<std::vector<int>> fans(int v) const;
  bool has_several_fans(int v) const { return fans(v).size() > 1; }
  bool is_on_boundary(int v) const;
  /// Returns the boundary curve through a boundary side: from side to side through the fan at its end.
  Cycle curve(int h) const;

  /// Returns V, E, F, boundary curves, components and genus, with a vertex for each fan.
  Delta counts() const;
  /// Returns the number of fans minus the number of vertices that have some.
  int excess_fans() const;
  /// Returns why this is not a manifold, apart from fans; "" when it is one.
  std::string broken() const;
  /// Returns the number of pairs of edges with the same ends, and of triangles with the same corners. With `at`, only
  /// those at a vertex.
  int doubled(int at = -1) const;

 private:
  template <typename Record>
  static bool in(int name, const std::vector<Record>& records) {
    return name >= 0 && static_cast<std::size_t>(name) < records.size();
  }
  static std::size_t at(int name) { return static_cast<std::size_t>(name); }
  /// Returns for each side the next one counter-clockwise around its start, -1 if a gap follows.
  std::vector<int> turns() const;
};

}  // namespace meshops::test
