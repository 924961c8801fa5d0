#include "bench/operator_task.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "bench/operator_openmesh.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"

namespace meshops_bench {
namespace {

/// Returns rows of squares. In the first row, the upper triangle of a square comes before the lower one: every triangle
/// is then glued to earlier ones at an edge, and meets them nowhere else.
Task grid_of(std::uint32_t side) {
  Task task{};
  task.vertices = (side + 1) * (side + 1);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = y * (side + 1) + x, b = a + 1, d = a + side + 1, c = d + 1;
      const Corners lower = {a, b, c}, upper = {a, c, d};
      task.triangles.push_back(y == 0 ? upper : lower);
      task.triangles.push_back(y == 0 ? lower : upper);
    }
  return task;
}

/// Returns two tubes, each with two rows of vertices; the numbers of the second follow those of the first.
Task tubes_of(std::uint32_t length) {
  Task task{};
  task.vertices = 4 * length;
  for (const std::uint32_t first : {0U, 2 * length})
    for (std::uint32_t i = 0; i < length; ++i) {
      const std::uint32_t a = first + i, b = first + (i + 1) % length, d = a + length, c = b + length;
      task.triangles.push_back({a, b, c});
      task.triangles.push_back({a, c, d});
    }
  // The upper curve of the first tube and the lower one of the second, as boundary halfedges that meet head to tail.
  for (std::uint32_t i = 0; i < length; ++i) {
    const std::uint32_t next = (i + 1) % length;
    task.sites.push_back({length + i, length + next, 0});
  }
  for (std::uint32_t i = 0; i < length; ++i) {
    const std::uint32_t next = (i + 1) % length;
    task.sites.push_back({2 * length + next, 2 * length + i, 0});
  }
  return task;
}

Corners corners_of(const TriMesh& mesh, meshops::Face f) {
  Corners corners{};
  std::size_t i = 0;
  for (const auto v : mesh.fv_range(f)) corners.at(i++) = static_cast<std::uint32_t>(v.idx());
  return corners;
}

void mix(Task& task, std::mt19937& random) {
  TriMesh mesh = mesh_of(task);
  std::uniform_int_distribution<int> any(0, static_cast<int>(mesh.n_edges()) - 1);
  for (std::size_t i = 0; i < mesh.n_edges(); ++i)
    if (const meshops::Edge e(any(random)); !meshops::flip_blocker(mesh, e)) meshops::flip(mesh, e);
  std::vector<std::uint32_t> number(task.vertices);
  std::iota(number.begin(), number.end(), 0U);
  std::shuffle(number.begin(), number.end(), random);
  task.triangles.clear();
  for (const auto f : mesh.faces()) {
    Corners corners = corners_of(mesh, f);
    for (std::uint32_t& corner : corners) corner = number[corner];
    task.triangles.push_back(corners);
  }
  // The order cannot be fully random: OpenMesh's add_face() refuses a triangle that would close a vertex in the wrong
  // order.
}

std::uint32_t index(meshops::Vertex v) { return static_cast<std::uint32_t>(v.idx()); }

class SiteFinder {
 public:
  SiteFinder(const Task& task, std::mt19937& random) : mesh_(mesh_of(task)), random_(random) {}

  std::vector<Site> edges(std::size_t count) {
    return some<meshops::Edge>(mesh_.n_edges(), count, [](meshops::Edge) { return true; });
  }
  std::vector<Site> faces(std::size_t count) {
    return some<meshops::Face>(mesh_.n_faces(), count, [](meshops::Face) { return true; });
  }
  /// Returns edges that can be flipped one after the other.
  std::vector<Site> flips(std::size_t count) {
    return some<meshops::Edge>(
        mesh_.n_edges(), count, [&](meshops::Edge e) { return !meshops::flip_blocker(mesh_, e); },
        [&](meshops::Edge e) { meshops::flip(mesh_, e); });
  }
  /// Returns halfedges of inner vertices whose stars share no vertex, and which can be collapsed one after the other.
  std::vector<Site> collapses() {
    return apart([&](meshops::Vertex v) { return ends(mesh_.halfedge_handle(v)); },
                 [&](const Site& s) {
                   const meshops::Halfedge h = halfedge(mesh_, s[0], s[1]);
                   if (meshops::collapse_blocker(mesh_, h)) return false;
                   meshops::collapse(mesh_, h);
                   return true;
                 });
  }
  /// Returns inner vertices whose stars share no vertex, each with two neighbors half a turn apart.
  std::vector<Site> vertices() {
    return apart(
        [&](meshops::Vertex v) {
          const meshops::Halfedge left = mesh_.halfedge_handle(v);
          meshops::Halfedge right = left;
          for (unsigned i = 0; i < mesh_.valence(v) / 2; ++i)
            right = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(right));
          return Site{index(v), index(mesh_.to_vertex_handle(left)), index(mesh_.to_vertex_handle(right))};
        },
        [](const Site&) { return true; });
  }
  /// Returns faces at these stars.
  std::vector<Site> faces_apart() {
    return apart([&](meshops::Vertex v) { return corners_of(mesh_, mesh_.face_handle(mesh_.halfedge_handle(v))); },
                 [](const Site&) { return true; });
  }

 private:
  template <typename Element>
  std::vector<Element> shuffled(std::size_t count) {
    std::vector<Element> elements;
    for (std::size_t i = 0; i < count; ++i) elements.emplace_back(static_cast<int>(i));
    std::shuffle(elements.begin(), elements.end(), random_);
    return elements;
  }
  Site site_of(meshops::Edge e) const { return ends(mesh_.halfedge_handle(e, 0)); }
  Site site_of(meshops::Face f) const { return corners_of(mesh_, f); }
  /// Returns the sites of `count` of the elements in random order that accept() lets pass, each before use() of it.
  template <typename Element, typename Accept, typename Use = void (*)(Element)>
  std::vector<Site> some(
      std::size_t of, std::size_t count, Accept accept, Use use = [](Element) {}) {
    std::vector<Site> sites;
    for (const Element element : shuffled<Element>(of)) {
      if (sites.size() == count) break;
      if (!accept(element)) continue;
      sites.push_back(site_of(element));
      use(element);
    }
    return sites;
  }
  Site ends(meshops::Halfedge h) const {
    return {index(mesh_.from_vertex_handle(h)), index(mesh_.to_vertex_handle(h)), 0};
  }
  template <typename SiteAt, typename Accept>
  std::vector<Site> apart(SiteAt site_at, Accept accept) {
    std::vector<bool> taken(mesh_.n_vertices(), false);
    std::vector<Site> sites;
    for (const meshops::Vertex v : shuffled<meshops::Vertex>(mesh_.n_vertices())) {
      std::vector<std::uint32_t> star = {index(v)};
      bool free = !mesh_.is_boundary(v);
      for (const auto w : mesh_.vv_range(v)) {
        star.push_back(index(w));
        free = free && !mesh_.is_boundary(w);
      }
      for (const std::uint32_t w : star) free = free && !taken[w];
      if (!free) continue;
      const Site site = site_at(v);
      if (!accept(site)) continue;
      sites.push_back(site);
      for (const std::uint32_t w : star) taken[w] = true;
    }
    return sites;
  }

  TriMesh mesh_;
  std::mt19937& random_;
};

std::vector<Site> find_sites(const Task& task, std::mt19937& random) {
  SiteFinder finder(task, random);
  switch (task.operation) {
    case Operation::split_edge:
      return finder.edges(task.triangles.size() / 4);
    case Operation::split_face:
      return finder.faces(task.triangles.size() / 4);
    case Operation::flip:
      return finder.flips(task.triangles.size() / 2);
    case Operation::collapse:
      return finder.collapses();
    case Operation::split_vertex:
      return finder.vertices();
    case Operation::open_curve:
    case Operation::close_curve:
      return finder.faces_apart();
    case Operation::add_triangles:
    case Operation::build_mesh:
    case Operation::sew_curves:
      break;
  }
  return {};
}

}  // namespace

std::string_view name(Operation operation) {
  constexpr std::string_view names[] = {"split_edge", "split_face",  "flip",          "collapse",   "split_vertex",
                                        "open_curve", "close_curve", "add_triangles", "build_mesh", "sew_curves"};
  return names[static_cast<std::size_t>(operation)];
}

std::string_view name(Ground ground) { return ground == Ground::grid ? "grid" : "random"; }

Task make_task(Operation operation, Ground ground) {
  std::mt19937 random(20241);
  Task task =
      operation == Operation::sew_curves ? tubes_of(100000) : grid_of(operation == Operation::build_mesh ? 708 : 317);
  task.operation = operation;
  if (ground == Ground::random) mix(task, random);
  if (operation == Operation::sew_curves) {
    task.steps = task.sites.size() / 2;
  } else {
    task.sites = find_sites(task, random);
    task.steps = task.sites.empty() ? task.triangles.size() : task.sites.size();
  }
  return task;
}

}  // namespace meshops_bench
