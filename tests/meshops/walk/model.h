// What: a mesh as nothing but oriented faces: each a cycle of sides, each side with a name and a vertex where it starts.
// Why:  the operators are done on it by their definitions, without links: the boundary, fans and curves follow from the
//       faces. What the library leaves must be the same, and what it refuses must be bad.
#pragma once

#include <string>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/core/delta.h"

namespace meshops::test {

using Cycle = std::vector<int>;

/// Names are handles: side h and side h ^ 1 are the two of an edge; a side that is in no face is on the boundary.
class Model {
 public:
  Model() = default;
  /// The live faces, edges and vertices of a mesh.
  explicit Model(const Connectivity& mesh);

  std::vector<Cycle> faces;      ///< by name, from the least side on; empty where there is none
  std::vector<int> from;         ///< the vertex at which a side starts, -1 where there is no edge
  std::vector<char> has_vertex;  ///< by name
  friend bool operator==(const Model& a, const Model& b);

  bool has_side(int h) const { return in(h, from) && from[at(h)] >= 0; }
  bool has_face(int f) const { return in(f, faces) && !faces[at(f)].empty(); }
  int to(int h) const { return from[at(h ^ 1)]; }
  /// The face that a side is in, -1 when there is none.
  int face_of(int h) const;
  bool is_boundary(int h) const { return face_of(h) < 0; }
  /// The cycle of a face, from `first` on.
  Cycle cycle(int f, int first) const;
  void set_face(int f, Cycle cycle);
  /// `heir` replaces a side in its face, when it is in one.
  void replace(int side, int heir);
  void erase_edge(int h);
  void rename_vertex(int old, int name);
  void add_edge(int h, int start, int end);
  void add_vertex(int v);

  /// All sides that leave a vertex.
  std::vector<int> leaving(int v) const;
  /// The sides that leave a vertex, those together that are joined by corners of faces, each fan counter-clockwise and
  /// from the boundary on where it begins.
  std::vector<std::vector<int>> fans(int v) const;
  bool has_several_fans(int v) const { return fans(v).size() > 1; }
  bool is_on_boundary(int v) const;
  /// The boundary curve through a boundary side, from fan to fan: from side to side through the fan at its end.
  Cycle curve(int h) const;

  /// V, E, F, boundary curves, components and genus, with a vertex for each fan.
  Delta counts() const;
  /// By how many there are more fans than vertices.
  int excess_fans() const;
  /// Why this is no manifold, apart from fans: "" when it is one.
  std::string broken() const;
  /// Pairs of edges with the same ends, and of triangles with the same corners. With `at`, only those at a vertex.
  int doubled(int at = -1) const;

 private:
  template <typename Record>
  static bool in(int name, const std::vector<Record>& records) {
    return name >= 0 && static_cast<std::size_t>(name) < records.size();
  }
  static std::size_t at(int name) { return static_cast<std::size_t>(name); }
  /// For each side the next one counter-clockwise around its start, -1 where a gap follows.
  std::vector<int> turns() const;
};

}  // namespace meshops::test
