// Compares operators of libmeshops with CGAL's Euler operations: the same faces after every step of random sequences.
#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <random>

#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/handle/close_curve.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/topology/build_mesh.h"
#include "oracle/cgal_euler.h"

namespace rbpa_test {
namespace {

struct TestMesh : OpenMesh::PolyMesh_ArrayKernelT<> {
  TestMesh() {
    request_vertex_status();
    request_edge_status();
    request_halfedge_status();
    request_face_status();
  }
};

/// Returns a grid of squares cut in two; opposite sides are one where it wraps.
std::vector<LabelledFace> grid(int columns, int rows, bool wrap_x, bool wrap_y) {
  const int nx = wrap_x ? columns : columns + 1, ny = wrap_y ? rows : rows + 1;
  const auto at = [&](int x, int y) { return (y % ny) * nx + x % nx; };
  std::vector<LabelledFace> faces;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return faces;
}

/// Runs the same operators on a mesh of ours and one of CGAL's. Labels are our vertex numbers.
class Pair {
 public:
  Pair(int vertices, const std::vector<LabelledFace>& faces, unsigned seed) : cgal_(vertices, faces), random_(seed) {
    meshops::PolygonSoup soup;
    soup.points = static_cast<std::size_t>(vertices);
    for (const LabelledFace& face : faces) soup.add_face(std::vector<std::uint32_t>(face.begin(), face.end()));
    meshops::build_mesh(mesh_, soup);
  }

  void step() {
    switch (random_() % 6) {
      case 0:
        return split_edge();
      case 1:
        return split_face();
      case 2:
      case 3:
        return flip();
      case 4:
        return random_() % 3 == 0 ? open_and_close() : collapse();
      default:
        return collapse();
    }
  }
  void check() const {
    CHECK(meshops::validate(mesh_).empty());
    std::vector<LabelledFace> ours;
    meshops::for_each_face(mesh_, [&](meshops::Face f) { ours.push_back(labels(f)); });
    std::sort(ours.begin(), ours.end());
    CHECK(ours == cgal_.faces());
    std::size_t border = 0;
    meshops::for_each_halfedge(mesh_, [&](meshops::Halfedge h) { border += mesh_.is_boundary(h); });
    CHECK(border == cgal_.border_halfedges());
  }
  int collapses = 0, refusals = 0, flips = 0, holes = 0;

 private:
  template <typename Handle>
  Handle any(std::size_t count) {
    for (;;)
      if (const Handle element(static_cast<int>(random_() % count)); meshops::is_live(mesh_, element)) return element;
  }
  int from(meshops::Halfedge h) const { return mesh_.from_vertex_handle(h).idx(); }
  int to(meshops::Halfedge h) const { return mesh_.to_vertex_handle(h).idx(); }
  LabelledFace labels(meshops::Face f) const {
    LabelledFace face;
    for (const auto v : mesh_.fv_range(f)) face.push_back(v.idx());
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  }

  void split_edge() {
    const auto h = any<meshops::Halfedge>(mesh_.n_halfedges());
    if (meshops::split_edge_blocker(mesh_, h)) return;
    const int a = from(h), b = to(h);
    cgal_.split_edge(a, b, meshops::split_edge(mesh_, h).added.vertex.idx());
  }
  void split_face() {
    const auto f = any<meshops::Face>(mesh_.n_faces());
    const LabelledFace face = labels(f);
    cgal_.split_face(face, meshops::split_face(mesh_, f).added.vertex.idx());
  }
  void flip() {
    const auto e = any<meshops::Edge>(mesh_.n_edges());
    if (meshops::flip_blocker(mesh_, e)) return;
    const meshops::Halfedge h = mesh_.halfedge_handle(e, 0);
    cgal_.flip(from(h), to(h));
    meshops::flip(mesh_, e);
    ++flips;
  }
  void collapse() {
    const auto h = any<meshops::Halfedge>(mesh_.n_halfedges());
    const bool blocked = meshops::collapse_blocker(mesh_, h).has_value();
    CHECK(blocked == !cgal_.can_collapse(from(h), to(h)));
    ++(blocked ? refusals : collapses);
    if (blocked) return;
    cgal_.collapse(from(h), to(h));
    meshops::collapse(mesh_, h);
  }
  void open_and_close() {
    const auto f = any<meshops::Face>(mesh_.n_faces());
    if (meshops::open_curve_blocker(mesh_, f)) return;
    cgal_.make_hole(labels(f));
    const meshops::Halfedge h = meshops::open_curve(mesh_, f).curve;
    check();
    cgal_.fill_hole(from(h), to(h));
    meshops::close_curve(mesh_, h);
    ++holes;
  }

  TestMesh mesh_;
  CgalEuler cgal_;
  std::mt19937 random_;
};

TEST_CASE("random sequences of operators leave the faces that CGAL's Euler operations leave") {
  int collapses = 0, refusals = 0, flips = 0, holes = 0;
  for (unsigned round = 0; round < 24; ++round) {
    const bool wrap_x = round % 2 == 1, wrap_y = round % 3 == 1;
    const int columns = 5, rows = 4;
    Pair pair((wrap_x ? columns : columns + 1) * (wrap_y ? rows : rows + 1), grid(columns, rows, wrap_x, wrap_y),
              round);
    pair.check();
    for (int step = 0; step < 400; ++step) {
      pair.step();
      if (step % 10 == 0) pair.check();
    }
    pair.check();
    collapses += pair.collapses;
    refusals += pair.refusals;
    flips += pair.flips;
    holes += pair.holes;
  }
  CHECK(collapses > 500);
  CHECK(refusals > 100);
  CHECK(flips > 500);
  CHECK(holes > 100);
}

TEST_CASE("collapses of small meshes are refused exactly where CGAL's link condition fails") {
  int refusals = 0;
  for (unsigned round = 0; round < 40; ++round) {
    // Begin with a tetrahedron, an octahedron and a disc; then apply random operators that keep them small.
    const std::vector<LabelledFace> tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    const std::vector<LabelledFace> octahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                                                  {1, 5, 2}, {2, 5, 3}, {3, 5, 4}, {1, 4, 5}};
    const std::vector<LabelledFace> disc = {{0, 1, 2}, {0, 2, 3}};
    const int which = static_cast<int>(round % 3);
    Pair pair(which == 0 ? 4 : which == 1 ? 6 : 4, which == 0 ? tetrahedron : which == 1 ? octahedron : disc, round);
    for (int step = 0; step < 300; ++step) pair.step();
    pair.check();
    refusals += pair.refusals;
  }
  CHECK(refusals > 100);
}

}  // namespace
}  // namespace rbpa_test
