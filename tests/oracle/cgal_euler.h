// What: runs CGAL's Euler operations on its Surface_mesh, addressed by labels of vertices.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace rbpa_test {

/// Face as the labels of its corners, from the least on.
using LabelledFace = std::vector<int>;

class CgalEuler {
 public:
  /// Builds a mesh. Labels are 0 to vertices − 1.
  CgalEuler(int vertices, const std::vector<LabelledFace>& faces);
  ~CgalEuler();

  // The new vertex gets the label. These require a triangle mesh.
  void split_edge(int from, int to, int label);
  void split_face(const LabelledFace& face, int label);
  void flip(int from, int to);
  bool can_collapse(int from, int to) const;
  void collapse(int from, int to);
  void make_hole(const LabelledFace& face);
  void fill_hole(int from, int to);

  std::vector<LabelledFace> faces() const;  ///< sorted
  std::size_t border_halfedges() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rbpa_test
