#include "walk/walk.h"

#include "meshops/handle/close_curve.h"
#include "meshops/handle/create.h"
#include "meshops/topology/build_mesh.h"
#include "support/bowties.h"
#include "support/soups.h"

namespace meshops::test {
namespace {

void cube(TestMesh& mesh) {
  build_mesh(mesh, soup(8, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}));
}

}  // namespace

Walk::Walk(Choices& choices, On on)
    : choices_(choices), on_(on), judge_(mesh_, on == On::bowties), arguments_(choices, mesh_) {
  start();
}

void Walk::start() {
  mesh_.clean();
  switch (choices_.below(9)) {
    case 0:
      build_mesh(mesh_, soup(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
      break;
    case 1:
      build_mesh(mesh_, grid_soup(3, 3, true, true));
      break;
    case 2:
      build_mesh(mesh_, grid_soup(3, 1, true, false));
      break;
    case 3:
      cube(mesh_);
      break;
    case 4:  // each fan on a point has a vertex
      build_mesh(mesh_, soup(8, {{0, 1, 2}, {0, 3, 4}, {0, 5, 6, 7}}));
      break;
    case 5:
      build_mesh(mesh_, beside(grid_soup(2, 2, false, false), grid_soup(3, 1, true, false)));
      break;
    case 6:  // two triangles with three common edges
      build_mesh(mesh_, soup(3, {{0, 1, 2}}));
      close_curve(mesh_, mesh_.opposite_halfedge_handle(mesh_.halfedge_handle(Face(0))));
      break;
    default:
      for (unsigned count = 1 + choices_.below(6); count > 0; --count) create_triangle(mesh_);
  }
}

void Walk::tidy() {
  if (mesh_.n_edges() > 250) mesh_.garbage_collection();  // remembered effects are then of another mesh
  if (on_ == On::bowties && choices_.one_in(5)) {
    const Halfedge h = arguments_.boundary(), g = arguments_.boundary();
    for (const Halfedge side : {h, g})
      if (!is_live(mesh_, side) || !mesh_.is_boundary(side)) return;
    const Vertex v = mesh_.from_vertex_handle(h), w = mesh_.from_vertex_handle(g);
    if (v != w && !mesh_.find_halfedge(v, w).is_valid()) tie(mesh_, v, w);
  }
}

void Walk::step() {
  using Step = void (Walk::*)();
  static constexpr Step growing[] = {&Walk::create, &Walk::split_edge, &Walk::split_face, &Walk::split_vertex};
  static constexpr Step others[] = {&Walk::glue,
                                    &Walk::glue,
                                    &Walk::glue,
                                    &Walk::glue,
                                    &Walk::unglue,
                                    &Walk::unglue,
                                    &Walk::destroy,
                                    &Walk::remove,
                                    &Walk::close,
                                    &Walk::open,
                                    &Walk::zip,
                                    &Walk::flip,
                                    &Walk::flip,
                                    &Walk::collapse,
                                    &Walk::collapse,
                                    &Walk::collapse,
                                    &Walk::weld_edge,
                                    &Walk::weld_face,
                                    &Walk::remove_vertex,
                                    &Walk::separate,
                                    &Walk::insert_diagonal,
                                    &Walk::remove_diagonal,
                                    &Walk::triangulate_face,
                                    &Walk::triangulate_face,
                                    &Walk::take_glue_back,
                                    &Walk::take_weld_back,
                                    &Walk::take_flip_back,
                                    &Walk::ask};
  tidy();
  std::size_t faces = 0;
  for_each_face(mesh_, [&](Face) { ++faces; });
  const unsigned grow = faces > 40 ? 0 : faces < 8 ? 2 : 4;
  if (faces < 3 || (grow > 0 && choices_.one_in(grow)))
    (this->*growing[choices_.below(std::size(growing))])();
  else
    (this->*others[choices_.below(std::size(others))])();
}

std::vector<int> Walk::corners(Face f) const {
  std::vector<int> all;
  if (!is_live(mesh_, f)) return all;
  const Halfedge first = mesh_.halfedge_handle(f);
  Halfedge h = first;
  do {
    all.push_back(mesh_.from_vertex_handle(h).idx());
    h = mesh_.next_halfedge_handle(h);
  } while (h != first);
  return all;
}

std::vector<int> Walk::on_curve(Halfedge first) const {
  std::vector<int> all;
  if (!is_live(mesh_, first) || !mesh_.is_boundary(first)) return all;
  Halfedge h = first;
  do {
    all.push_back(mesh_.from_vertex_handle(h).idx());
    h = mesh_.next_halfedge_handle(h);
  } while (h != first);
  return all;
}

std::vector<int> Walk::ends(Halfedge h) const {
  if (!is_live(mesh_, h)) return {};
  return {mesh_.from_vertex_handle(h).idx(), mesh_.to_vertex_handle(h).idx()};
}

bool Walk::is_dead(int name, const std::vector<char>& live) const {
  return name >= 0 && static_cast<std::size_t>(name) < live.size() && !live[static_cast<std::size_t>(name)];
}

}  // namespace meshops::test
