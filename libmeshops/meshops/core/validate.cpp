#include "meshops/core/validate.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "meshops/core/live.h"

namespace meshops {
namespace {

class Validator {
 public:
  explicit Validator(const Connectivity& mesh) : mesh_(mesh) {}

  std::vector<Defect> run() {
    check_halfedge_ranges();
    // The checks below follow handles, which is safe only if the handles exist.
    if (defects_.empty()) {
      check_halfedges();
      check_faces();
      check_vertices();
    }
    std::stable_sort(defects_.begin(), defects_.end(),
                     [](const Defect& a, const Defect& b) { return a.element < b.element; });
    return std::move(defects_);
  }

 private:
  void add(DefectKind kind, ElementKind element, int index) { defects_.push_back({kind, element, index}); }

  template <typename Element>
  bool alive(Element element) const {
    return is_live(mesh_, element);
  }

  void check_halfedge_ranges() {
    for_each_halfedge(mesh_, [&](Halfedge h) {
      const Face f = mesh_.face_handle(h);
      if (!alive(mesh_.to_vertex_handle(h)) || !alive(mesh_.next_halfedge_handle(h)) ||
          !alive(mesh_.prev_halfedge_handle(h)) || (f.is_valid() && !alive(f)))
        add(DefectKind::handle_out_of_range, ElementKind::halfedge, h.idx());
    });
    for_each_face(mesh_, [&](Face f) {
      if (!alive(mesh_.halfedge_handle(f))) add(DefectKind::handle_out_of_range, ElementKind::face, f.idx());
    });
    for_each_vertex(mesh_, [&](Vertex v) {
      if (!mesh_.is_isolated(v) && !alive(mesh_.halfedge_handle(v)))
        add(DefectKind::handle_out_of_range, ElementKind::vertex, v.idx());
    });
  }

  void check_halfedges() {
    for_each_halfedge(mesh_, [&](Halfedge h) {
      const Halfedge next = mesh_.next_halfedge_handle(h);
      if (mesh_.prev_halfedge_handle(next) != h || mesh_.next_halfedge_handle(mesh_.prev_halfedge_handle(h)) != h)
        add(DefectKind::next_and_prev_disagree, ElementKind::halfedge, h.idx());
      if (mesh_.from_vertex_handle(next) != mesh_.to_vertex_handle(h))
        add(DefectKind::halfedges_do_not_meet, ElementKind::halfedge, h.idx());
      if (mesh_.face_handle(next) != mesh_.face_handle(h))
        add(DefectKind::face_changes_along_loop, ElementKind::halfedge, h.idx());
      if (h.idx() % 2 == 0) {
        if (mesh_.from_vertex_handle(h) == mesh_.to_vertex_handle(h))
          add(DefectKind::loop_edge, ElementKind::halfedge, h.idx());
        if (mesh_.is_boundary(h) && mesh_.is_boundary(mesh_.opposite_halfedge_handle(h)))
          add(DefectKind::dangling_edge, ElementKind::halfedge, h.idx());
      }
    });
  }

  void check_faces() {
    std::vector<std::size_t> sides_of(mesh_.n_faces(), 0);
    for_each_halfedge(mesh_, [&](Halfedge h) {
      if (!mesh_.is_boundary(h)) ++sides_of[static_cast<std::size_t>(mesh_.face_handle(h).idx())];
    });
    for_each_face(mesh_, [&](Face f) {
      const Halfedge first = mesh_.halfedge_handle(f);
      if (mesh_.face_handle(first) != f) {
        add(DefectKind::face_halfedge_elsewhere, ElementKind::face, f.idx());
        return;
      }
      const std::size_t sides = sides_of[static_cast<std::size_t>(f.idx())];
      std::size_t steps = 0;
      Halfedge h = first;
      do {
        h = mesh_.next_halfedge_handle(h);
      } while (++steps <= sides && h != first && mesh_.face_handle(h) == f);
      if (h != first) {
        // check_halfedges() has reported the change of face along the loop already.
        if (steps > sides) add(DefectKind::loop_does_not_close, ElementKind::face, f.idx());
        return;
      }
      if (steps < sides) add(DefectKind::face_has_several_loops, ElementKind::face, f.idx());
      if (steps < 3) add(DefectKind::face_too_short, ElementKind::face, f.idx());
    });
  }

  void check_vertices() {
    std::vector<int> outgoing(mesh_.n_vertices(), 0);
    std::vector<int> gaps(mesh_.n_vertices(), 0);
    for_each_halfedge(mesh_, [&](Halfedge h) {
      const auto v = static_cast<std::size_t>(mesh_.from_vertex_handle(h).idx());
      ++outgoing[v];
      if (mesh_.is_boundary(h)) ++gaps[v];
    });
    for_each_vertex(mesh_, [&](Vertex v) {
      const int degree = outgoing[static_cast<std::size_t>(v.idx())];
      if (mesh_.is_isolated(v)) {
        if (degree != 0) add(DefectKind::vertex_halfedge_elsewhere, ElementKind::vertex, v.idx());
        return;
      }
      const Halfedge first = mesh_.halfedge_handle(v);
      if (mesh_.from_vertex_handle(first) != v) {
        add(DefectKind::vertex_halfedge_elsewhere, ElementKind::vertex, v.idx());
        return;
      }
      const int gaps_here = gaps[static_cast<std::size_t>(v.idx())];
      if (gaps_here > 0 && !mesh_.is_boundary(first))
        add(DefectKind::vertex_halfedge_inner, ElementKind::vertex, v.idx());
      int reached = 0;
      Halfedge h = first;
      do {
        h = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h));
      } while (++reached <= degree && h != first);
      // There are several rings, or one ring with several gaps; between two gaps there is a fan.
      if (reached != degree || h != first || gaps_here > 1)
        add(DefectKind::vertex_has_several_fans, ElementKind::vertex, v.idx());
    });
  }

  const Connectivity& mesh_;
  std::vector<Defect> defects_;
};

}  // namespace

std::string_view name(DefectKind kind) {
  static constexpr std::array<std::string_view, 13> names = {
      "handle out of range",     "next and prev disagree",    "halfedges do not meet",
      "face changes along loop", "face halfedge elsewhere",   "face too short",
      "loop does not close",     "face has several loops",    "loop edge",
      "dangling edge",           "vertex halfedge elsewhere", "vertex halfedge inner",
      "vertex has several fans"};
  return names[static_cast<std::size_t>(kind)];
}

std::string describe(const Defect& defect) {
  return std::string(name(defect.element)) + ' ' + std::to_string(defect.index) + ": " + std::string(name(defect.kind));
}

std::vector<Defect> validate(const Connectivity& mesh) { return Validator(mesh).run(); }

}  // namespace meshops
