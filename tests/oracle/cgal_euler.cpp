#include "oracle/cgal_euler.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <stdexcept>

namespace rbpa_test {
namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;

}  // namespace

struct CgalEuler::Impl {
  Mesh mesh;
  std::vector<Vertex> vertex;  // for each label
  Mesh::Property_map<Vertex, int> label;

  void set_label(Vertex v, int l) {
    if (vertex.size() <= static_cast<std::size_t>(l)) vertex.resize(static_cast<std::size_t>(l) + 1);
    vertex[static_cast<std::size_t>(l)] = v;
    label[v] = l;
  }
  Halfedge between(int from, int to) const {
    const auto found =
        CGAL::halfedge(vertex[static_cast<std::size_t>(from)], vertex[static_cast<std::size_t>(to)], mesh);
    if (!found.second) throw std::runtime_error("CGAL's mesh has no such edge");
    return found.first;
  }
};

CgalEuler::CgalEuler(int vertices, const std::vector<LabelledFace>& faces) : impl_(std::make_unique<Impl>()) {
  impl_->label = impl_->mesh.add_property_map<Vertex, int>("label", -1).first;
  for (int l = 0; l < vertices; ++l) impl_->set_label(impl_->mesh.add_vertex(), l);
  for (const LabelledFace& face : faces) {
    std::vector<Vertex> corners;
    for (const int l : face) corners.push_back(impl_->vertex[static_cast<std::size_t>(l)]);
    if (impl_->mesh.add_face(corners) == Mesh::null_face()) throw std::runtime_error("CGAL does not take the face");
  }
}

CgalEuler::~CgalEuler() = default;

void CgalEuler::split_edge(int from, int to, int label) {
  Mesh& mesh = impl_->mesh;
  const Halfedge h = impl_->between(from, to);
  const Halfedge half = CGAL::Euler::split_edge(h, mesh);  // ends at the new vertex, at which h begins now
  impl_->set_label(mesh.target(half), label);
  if (!mesh.is_border(h)) CGAL::Euler::split_face(half, mesh.next(h), mesh);
  const Halfedge back = mesh.opposite(h);
  if (!mesh.is_border(back)) CGAL::Euler::split_face(back, mesh.next(mesh.next(back)), mesh);
}

void CgalEuler::split_face(const LabelledFace& face, int label) {
  const Halfedge h = impl_->between(face[0], face[1]);
  impl_->set_label(impl_->mesh.target(CGAL::Euler::add_center_vertex(h, impl_->mesh)), label);
}

void CgalEuler::flip(int from, int to) { CGAL::Euler::flip_edge(impl_->between(from, to), impl_->mesh); }

bool CgalEuler::can_collapse(int from, int to) const {
  return CGAL::Euler::does_satisfy_link_condition(impl_->mesh.edge(impl_->between(from, to)), impl_->mesh);
}

void CgalEuler::collapse(int from, int to) {
  impl_->set_label(CGAL::Euler::collapse_edge(impl_->mesh.edge(impl_->between(from, to)), impl_->mesh), to);
}

void CgalEuler::make_hole(const LabelledFace& face) {
  CGAL::Euler::make_hole(impl_->between(face[0], face[1]), impl_->mesh);
}

void CgalEuler::fill_hole(int from, int to) { CGAL::Euler::fill_hole(impl_->between(from, to), impl_->mesh); }

std::vector<LabelledFace> CgalEuler::faces() const {
  std::vector<LabelledFace> all;
  for (const auto f : impl_->mesh.faces()) {
    LabelledFace face;
    for (const auto v : impl_->mesh.vertices_around_face(impl_->mesh.halfedge(f))) face.push_back(impl_->label[v]);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    all.push_back(std::move(face));
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::size_t CgalEuler::border_halfedges() const {
  const auto halfedges = impl_->mesh.halfedges();
  return static_cast<std::size_t>(
      std::count_if(halfedges.begin(), halfedges.end(), [&](Halfedge h) { return impl_->mesh.is_border(h); }));
}

}  // namespace rbpa_test
