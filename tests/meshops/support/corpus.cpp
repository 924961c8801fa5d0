#include "support/corpus.h"

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>

#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/create.h"
#include "meshops/handle/glue.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/topology/count.h"

namespace meshops::test {
namespace {

void one_triangle(TestMesh& mesh) { create_triangle(mesh); }

void square(TestMesh& mesh) { add_triangles(mesh, 4, {{0, 1, 2}, {0, 2, 3}}); }

/// A wheel: a center and a rim.
void wheel(TestMesh& mesh) {
  std::vector<Corners> t;
  for (int i = 0; i < 6; ++i) t.push_back({0, 1 + i, 1 + (i + 1) % 6});
  add_triangles(mesh, 7, t);
}

/// A grid of squares cut in two; `wrap` has the directions in which its sides are one.
std::vector<Corners> grid(int columns, int rows, bool wrap_x, bool wrap_y, int first = 0) {
  const int nx = wrap_x ? columns : columns + 1, ny = wrap_y ? rows : rows + 1;
  std::vector<Corners> t;
  const auto at = [&](int x, int y) { return first + (y % ny) * nx + x % nx; };
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      t.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      t.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return t;
}

void disc(TestMesh& mesh) { add_triangles(mesh, 30, grid(5, 4, false, false)); }
void annulus(TestMesh& mesh) { add_triangles(mesh, 15, grid(5, 2, true, false)); }
void tetrahedron(TestMesh& mesh) { add_triangles(mesh, 4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}); }
void octahedron(TestMesh& mesh) {
  add_triangles(mesh, 6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}});
}
void torus(TestMesh& mesh) { add_triangles(mesh, 20, grid(5, 4, true, true)); }

/// Two tori, each without one triangle, sewn along the gaps.
void double_torus(TestMesh& mesh) {
  auto t = grid(5, 4, true, true);
  auto other = grid(5, 4, true, true, 20);
  // The last triangle of each goes; the corners of the second become those of the first, in reverse.
  const Corners gap = t.back();
  const Corners gap_of_other = other.back();
  t.pop_back();
  other.pop_back();
  std::map<int, int> renamed;
  for (unsigned i = 0; i < 3; ++i) renamed[gap_of_other[i]] = gap[(3 - i) % 3];
  int next = 20;
  for (Corners& c : other)
    for (int& v : c) {
      const auto [slot, isnew] = renamed.try_emplace(v, next);
      if (isnew) ++next;
      v = slot->second;
    }
  t.insert(t.end(), other.begin(), other.end());
  add_triangles(mesh, next, t);
}

/// Fans that would touch in a point: each has a vertex of its own for it.
void pinched_fans(TestMesh& mesh) {
  std::vector<Corners> t;
  for (int fan = 0; fan < 3; ++fan)
    for (int i = 0; i < 3; ++i) t.push_back({5 * fan, 5 * fan + 1 + i, 5 * fan + 2 + i});
  add_triangles(mesh, 15, t);
}

void two_components(TestMesh& mesh) {
  auto t = grid(3, 3, false, false);
  const auto closed = grid(4, 3, true, true, 16);
  t.insert(t.end(), closed.begin(), closed.end());
  add_triangles(mesh, 28, t);
}

/// Triangles glued at random: many curves and handles, edges that join the same vertices.
void random_gluings(TestMesh& mesh) {
  std::mt19937 random(20040917);
  std::vector<Halfedge> open = separate_triangles(mesh, 1000);
  // Join to one component, then glue on: neighbors often, any others seldom.
  for (std::size_t t = 1; t < 1000; ++t)
    for (;;) {
      const Halfedge h = open[random() % (3 * t)];
      if (!is_live(mesh, h) || !mesh.is_boundary(h) || glue_blocker(mesh, h, open[3 * t])) continue;
      glue(mesh, h, open[3 * t]);
      break;
    }
  for (int step = 0; step < 1500; ++step) {
    open.erase(
        std::remove_if(open.begin(), open.end(), [&](Halfedge h) { return !is_live(mesh, h) || !mesh.is_boundary(h); }),
        open.end());
    if (open.size() < 40) break;
    const Halfedge h = open[random() % open.size()];
    const Halfedge with = random() % 8 ? mesh.next_halfedge_handle(h) : open[random() % open.size()];
    if (!glue_blocker(mesh, h, with)) glue(mesh, h, with);
  }
}

/// A thousand triangles less thirty holes of a square each, apart from each other and from the rim.
void perforated_disc(TestMesh& mesh) {
  const auto all = grid(25, 20, false, false);
  std::vector<Corners> kept;
  for (int square = 0; square < 500; ++square) {
    if (square % 25 % 4 == 2 && square / 25 % 4 == 2) continue;
    kept.push_back(all[static_cast<std::size_t>(2 * square)]);
    kept.push_back(all[static_cast<std::size_t>(2 * square + 1)]);
  }
  add_triangles(mesh, 26 * 21, kept);
}

/// A double torus with two holes after random stellar operators: a thousand triangles, no double edges.
void random_stellar(TestMesh& mesh) {
  double_torus(mesh);
  for (const int f : {3, 60}) open_curve(mesh, Face(f));
  std::mt19937 random(1978);
  while (count_topology(mesh).faces < 1000) {
    for (int step = 0; step < 20; ++step) {
      const Edge e(static_cast<int>(random() % mesh.n_edges()));
      const Halfedge h = mesh.halfedge_handle(e, static_cast<unsigned>(random() % 2));
      if (!is_live(mesh, e)) continue;
      const auto what = random() % 8;
      if (what < 2 && !mesh.is_boundary(h)) split_face(mesh, mesh.face_handle(h));
      if (what == 2 && !split_edge_blocker(mesh, h)) split_edge(mesh, h);
      if (what > 2 && what < 7 && !flip_blocker(mesh, e)) flip(mesh, e);
      if (what == 7 && !collapse_blocker(mesh, h)) collapse(mesh, h);
    }
  }
  mesh.garbage_collection();
}

/// The traversal of a component from a halfedge, as numbers that do not depend on handles; empty as soon as it is
/// greater than `best`, when that is not empty.
std::vector<int> traverse(const Connectivity& mesh, Halfedge start, const std::vector<int>& best,
                          std::vector<int>& number) {
  std::vector<Halfedge> order = {start};
  std::vector<int> code;
  const auto number_of = [&](Halfedge h) {
    int& n = number[static_cast<std::size_t>(h.idx())];
    if (n < 0) {
      n = static_cast<int>(order.size());
      order.push_back(h);
    }
    return n;
  };
  number[static_cast<std::size_t>(start.idx())] = 0;
  bool less = best.empty();
  bool greater = false;
  for (std::size_t i = 0; i < order.size() && !greater; ++i) {
    const Halfedge h = order[i];
    for (const int value : {static_cast<int>(mesh.is_boundary(h)), number_of(mesh.next_halfedge_handle(h)),
                            number_of(mesh.opposite_halfedge_handle(h))}) {
      if (!less) {
        const std::size_t at = code.size();
        if (at < best.size() && value < best[at]) less = true;
        if (at < best.size() && value > best[at]) greater = true;
      }
      code.push_back(value);
      if (greater) break;
    }
  }
  for (const Halfedge h : order) number[static_cast<std::size_t>(h.idx())] = -1;
  if (greater) code.clear();
  return code;
}

}  // namespace

void add_triangles(TestMesh& mesh, int vertices, const std::vector<Corners>& triangles) {
  std::vector<Vertex> v;
  for (int i = 0; i < vertices; ++i) v.push_back(mesh.new_vertex());
  for (const Corners& t : triangles) {
    const auto at = [&](unsigned i) { return v[static_cast<std::size_t>(t[i])]; };
    if (!mesh.add_face(at(0), at(1), at(2)).is_valid()) throw std::logic_error("add_triangles: no manifold");
  }
  if (!validate(mesh).empty()) throw std::logic_error("add_triangles: no manifold");
}

const std::vector<Specimen>& corpus() {
  static const std::vector<Specimen> all = {
      {"one triangle", one_triangle, 1, 1, 0, true},
      {"square", square, 1, 1, 0, true},
      {"wheel", wheel, 1, 1, 0, true},
      {"disc", disc, 1, 1, 0, true},
      {"annulus", annulus, 1, 2, 0, true},
      {"tetrahedron", tetrahedron, 1, 0, 0, true},
      {"octahedron", octahedron, 1, 0, 0, true},
      {"torus", torus, 1, 0, 1, true},
      {"double torus", double_torus, 1, 0, 2, true},
      {"pinched fans", pinched_fans, 3, 3, 0, true},
      {"two components", two_components, 2, 1, 1, true},
      {"perforated disc", perforated_disc, 1, 31, 0, true},
      {"random stellar", random_stellar, 1, 2, 2, true},
      {"random gluings", random_gluings, 1, 2, 35, false},
  };
  return all;
}

std::string isomorphism_class(const Connectivity& mesh) {
  std::vector<int> number(mesh.n_halfedges(), -1);
  std::vector<char> done(mesh.n_halfedges(), 0);
  std::vector<std::vector<int>> components;
  for_each_halfedge(mesh, [&](Halfedge seed) {
    if (done[static_cast<std::size_t>(seed.idx())]) return;
    std::vector<Halfedge> members = {seed};
    done[static_cast<std::size_t>(seed.idx())] = 1;
    for (std::size_t i = 0; i < members.size(); ++i)
      for (const Halfedge h : {mesh.next_halfedge_handle(members[i]), mesh.opposite_halfedge_handle(members[i])})
        if (char& mark = done[static_cast<std::size_t>(h.idx())]; !mark) {
          mark = 1;
          members.push_back(h);
        }
    std::vector<int> best;
    for (const Halfedge h : members)
      if (auto code = traverse(mesh, h, best, number); !code.empty()) best = std::move(code);
    components.push_back(std::move(best));
  });
  std::sort(components.begin(), components.end());
  int isolated = 0;
  for_each_vertex(mesh, [&](Vertex v) { isolated += mesh.is_isolated(v); });
  std::string text = std::to_string(isolated) + " isolated";
  for (const auto& code : components) {
    text += ';';
    for (const int value : code) text += ' ' + std::to_string(value);
  }
  return text;
}

}  // namespace meshops::test
