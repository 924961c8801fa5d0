#include "walk/model.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "meshops/core/live.h"

namespace meshops::test {

Model::Model(const Connectivity& mesh)
    : faces(mesh.n_faces()), from(mesh.n_halfedges(), -1), has_vertex(mesh.n_vertices(), 0) {
  for_each_vertex(mesh, [&](Vertex v) { has_vertex[at(v.idx())] = 1; });
  for_each_halfedge(mesh, [&](Halfedge h) { from[at(h.idx())] = mesh.from_vertex_handle(h).idx(); });
  for_each_face(mesh, [&](Face f) {
    Cycle sides;
    Halfedge h = mesh.halfedge_handle(f);
    do {
      sides.push_back(h.idx());
      h = mesh.next_halfedge_handle(h);
    } while (h != mesh.halfedge_handle(f) && sides.size() <= mesh.n_halfedges());
    set_face(f.idx(), std::move(sides));
  });
}

bool operator==(const Model& a, const Model& b) {
  // Unused names do not count.
  const auto same = [](const auto& x, const auto& y, const auto& none) {
    for (std::size_t i = 0; i < std::max(x.size(), y.size()); ++i)
      if ((i < x.size() ? x[i] : none) != (i < y.size() ? y[i] : none)) return false;
    return true;
  };
  return same(a.faces, b.faces, Cycle()) && same(a.from, b.from, -1) && same(a.has_vertex, b.has_vertex, char(0));
}

int Model::face_of(int h) const {
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (std::find(faces[f].begin(), faces[f].end(), h) != faces[f].end()) return static_cast<int>(f);
  return -1;
}

Cycle Model::cycle(int f, int first) const {
  Cycle sides = faces[at(f)];
  std::rotate(sides.begin(), std::find(sides.begin(), sides.end(), first), sides.end());
  return sides;
}

void Model::set_face(int f, Cycle sides) {
  if (at(f) >= faces.size()) faces.resize(at(f) + 1);
  std::rotate(sides.begin(), std::min_element(sides.begin(), sides.end()), sides.end());
  faces[at(f)] = std::move(sides);
}

void Model::replace(int side, int heir) {
  const int f = face_of(side);
  if (f < 0) return;
  Cycle sides = faces[at(f)];
  std::replace(sides.begin(), sides.end(), side, heir);
  set_face(f, std::move(sides));
}

void Model::erase_edge(int h) { from[at(h)] = from[at(h ^ 1)] = -1; }

void Model::rename_vertex(int old, int name) {
  if (old == name) return;
  std::replace(from.begin(), from.end(), old, name);
  has_vertex[at(old)] = 0;
  add_vertex(name);
}

void Model::add_edge(int h, int start, int end) {
  if (at(h | 1) >= from.size()) from.resize(at(h | 1) + 1, -1);
  from[at(h)] = start;
  from[at(h ^ 1)] = end;
}

void Model::add_vertex(int v) {
  if (at(v) >= has_vertex.size()) has_vertex.resize(at(v) + 1, 0);
  has_vertex[at(v)] = 1;
}

std::vector<int> Model::leaving(int v) const {
  std::vector<int> out;
  for (std::size_t h = 0; h < from.size(); ++h)
    if (from[h] == v) out.push_back(static_cast<int>(h));
  return out;
}

std::vector<int> Model::turns() const {
  std::vector<int> turn(from.size(), -1);
  for (const Cycle& sides : faces)
    for (std::size_t i = 0; i < sides.size(); ++i)
      turn[at(sides[i])] = sides[(i + sides.size() - 1) % sides.size()] ^ 1;
  return turn;
}

std::vector<std::vector<int>> Model::fans(int v) const {
  const std::vector<int> turn = turns(), out = leaving(v);
  std::vector<std::vector<int>> all;
  std::vector<char> done(from.size(), 0), follows(from.size(), 0);
  for (const int h : out)
    if (turn[at(h)] >= 0) follows[at(turn[at(h)])] = 1;
  const auto collect = [&](int first) {
    all.emplace_back();
    for (int h = first; h >= 0 && !done[at(h)]; h = turn[at(h)]) {
      done[at(h)] = 1;
      all.back().push_back(h);
    }
  };
  for (const int h : out)  // open fans
    if (!follows[at(h)]) collect(h);
  for (const int h : out)  // closed fans
    if (!done[at(h)]) collect(h);
  return all;
}

bool Model::is_on_boundary(int v) const {
  const std::vector<int> out = leaving(v);
  return std::any_of(out.begin(), out.end(), [&](int h) { return is_boundary(h); });
}

Cycle Model::curve(int h) const {
  const std::vector<int> turn = turns();
  Cycle sides = {h};
  for (;;) {
    int out = sides.back() ^ 1;  // through the fan, counter-clockwise, to its end
    while (turn[at(out)] >= 0) out = turn[at(out)];
    if (out == h || sides.size() > from.size()) return sides;
    sides.push_back(out);
  }
}

int Model::excess_fans() const {
  // Each corner joins two of the edges at a vertex; a closed fan has as many corners as edges.
  const std::vector<int> turn = turns();
  int excess = 0;
  std::vector<int> fans_at(has_vertex.size(), 0);
  std::vector<char> done(from.size(), 0), follows(from.size(), 0);
  for (const int next : turn)
    if (next >= 0) follows[at(next)] = 1;
  for (const bool closed : {false, true})
    for (std::size_t h = 0; h < from.size(); ++h) {
      if (from[h] < 0 || done[h] || (!closed && follows[h])) continue;
      if (++fans_at[at(from[h])] > 1) ++excess;
      for (int out = static_cast<int>(h); out >= 0 && !done[at(out)]; out = turn[at(out)]) done[at(out)] = 1;
    }
  return excess;
}

Delta Model::counts() const {
  Delta sum;
  const std::vector<int> turn = turns();
  std::vector<int> set(from.size());  // sets of sides that are connected through faces and edges
  std::iota(set.begin(), set.end(), 0);
  const auto find = [&](int h) {
    while (set[at(h)] != h) h = set[at(h)] = set[at(set[at(h)])];
    return h;
  };
  for (std::size_t h = 0; h < from.size(); ++h) {
    if (from[h] < 0) continue;
    set[at(find(static_cast<int>(h)))] = find(static_cast<int>(h ^ 1));
    if (turn[h] >= 0) set[at(find(static_cast<int>(h)))] = find(turn[h]);
  }
  std::vector<char> used(has_vertex.size(), 0), on_known_curve(from.size(), 0);
  int isolated = 0;
  for (std::size_t h = 0; h < from.size(); ++h) {
    if (from[h] < 0) continue;
    used[at(from[h])] = 1;
    if (h % 2 == 0) ++sum.edges;
    if (find(static_cast<int>(h)) == static_cast<int>(h)) ++sum.components;
    if (turn[h] >= 0 || on_known_curve[h]) continue;
    ++sum.curves;
    for (const int side : curve(static_cast<int>(h))) on_known_curve[at(side)] = 1;
  }
  for (std::size_t v = 0; v < has_vertex.size(); ++v) {
    sum.vertices += has_vertex[v];
    isolated += has_vertex[v] && !used[v];
  }
  for (const Cycle& sides : faces) sum.faces += !sides.empty();
  sum.genus = (2 * sum.components - sum.curves - (sum.vertices - isolated + excess_fans() - sum.edges + sum.faces)) / 2;
  sum.components += isolated;
  return sum;
}

std::string Model::broken() const {
  std::vector<char> has_face(from.size(), 0);
  for (const Cycle& sides : faces) {
    if (sides.empty()) continue;
    if (sides.size() < 3) return "a face of two sides";
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const int h = sides[i], next = sides[(i + 1) % sides.size()];
      if (!has_side(h)) return "a side without an edge";
      if (has_face[at(h)]++) return "a side in two faces";
      if (to(h) != from[at(next)]) return "sides that do not meet";
    }
  }
  for (std::size_t h = 0; h < from.size(); ++h) {
    if (from[h] < 0) continue;
    if (!in(from[h], has_vertex) || !has_vertex[at(from[h])]) return "an edge without a vertex";
    if (from[h] == to(static_cast<int>(h))) return "a loop";
    if (!has_face[h] && !has_face[h ^ 1]) return "an edge without a face";
  }
  return "";
}

int Model::doubled(int vertex) const {
  std::vector<std::array<int, 2>> ends;
  std::vector<std::array<int, 3>> corners;
  const auto counts = [&](const auto& all) {
    return vertex < 0 || std::find(all.begin(), all.end(), vertex) != all.end();
  };
  for (int h = 0; at(h) < from.size(); h += 2)
    if (from[at(h)] >= 0)
      if (const std::array pair = {std::min(from[at(h)], to(h)), std::max(from[at(h)], to(h))}; counts(pair))
        ends.push_back(pair);
  for (const Cycle& sides : faces) {
    if (sides.size() != 3) continue;
    std::array<int, 3> triple = {from[at(sides[0])], from[at(sides[1])], from[at(sides[2])]};
    std::sort(triple.begin(), triple.end());
    if (counts(triple)) corners.push_back(triple);
  }
  const auto repeated = [](auto all) {
    std::sort(all.begin(), all.end());
    int pairs = 0;
    for (std::size_t i = 0, same = 0; i + 1 < all.size(); ++i) {
      same = all[i] == all[i + 1] ? same + 1 : 0;
      pairs += static_cast<int>(same);
    }
    return pairs;
  };
  return repeated(ends) + repeated(corners);
}

}  // namespace meshops::test
